#pragma once

#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "loaders/course/scene_text.h"
#include "scene_spec/param_set.h"

namespace candela {

/// Reads the parts all blocks of a scene share: braces, lists of blocks, lists of named parameters.
///
/// One mistake shall give one message. So reading goes on after it with what was probably meant: a
/// misspelt block is taken for the one it resembles, a block whose closing brace is missing ends
/// where another one begins that cannot stand in it, and what cannot be understood is skipped up to
/// the next thing that can.
class BlockReader {
 public:
  /// Whether a block may hold two parameters of one name in earnest.
  enum class Repeats { kLegal, kOdd };

  /// Whether `texture` behind the name of a parameter announces the name of one.
  enum class Textures { kNone, kByName };

  BlockReader(SceneText* tokens, Diagnostics* diagnostics)
      : tokens_(*tokens), diagnostics_(*diagnostics) {}

  /// Takes the opening brace that has to follow `opener`. When it is missing that is reported, and
  /// reading can go on as if it were there. False when it is missing.
  bool OpenBlock(const Token& opener);

  /// The next token in a list of blocks that begin with the words `accepted`: such a word, a
  /// closing brace, or the end. Other words are reported and never returned, and where a file is
  /// included, its blocks are taken as if they stood there. `opener` is the word
  /// that began the list, null on the top level; when the file ends in it, or a section of the
  /// scene begins, that is reported too, and for the list it is the end.
  Token NextItem(const Token* opener, std::span<const std::string_view> accepted);

  /// Reads the block that `opener` announces: its braces and `name value ...` in between. A value
  /// is a run of numbers, or a word with such a run behind it, or a texture.
  ParamSet ReadParams(const Token& opener, Repeats repeats = Repeats::kOdd,
                      Textures textures = Textures::kNone);

  /// True once the file has ended inside a block or a section could not be read, which was
  /// reported: a section that is missing is then no mistake of its own.
  bool HasLostSections() const { return is_cut_short_ || has_skipped_section_; }

 private:
  void EndsWithoutBrace(const Token& opener);
  Param ReadParam(Textures textures);
  void NoParam();
  void SkipBlock();

  SceneText& tokens_;
  Diagnostics& diagnostics_;
  bool is_cut_short_ = false;
  bool has_skipped_section_ = false;
};

}  // namespace candela
