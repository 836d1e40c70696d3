#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "loaders/text/tokenizer.h"

namespace candela {

/// The words of a scene file and of those that it includes. One file is read at a time: an included
/// one up to its end, which has to be left like that of a block.
class SceneText {
 public:
  /// Files may include each other so deep, and be included so often in all.
  static constexpr size_t kDeepest = 64;
  static constexpr size_t kMostIncludes = 10000;

  /// `folder` is where the scene file lies. `text` and `diagnostics` must outlive the object.
  SceneText(std::shared_ptr<const std::string> file, std::string_view text,
            const std::filesystem::path& folder, Diagnostics* diagnostics);

  /// Of the file that is being read; see `Tokenizer`.
  Token Next() { return files_.back().tokens.Next(); }
  const Token& Peek() const { return files_.back().tokens.Peek(); }
  const Token& PeekSecond() const { return files_.back().tokens.PeekSecond(); }

  /// The place of a token of any of the open files.
  SourceLocation Where(const Token& token) const { return files_[token.file].tokens.Where(token); }

  /// Reads the name of a file, which follows the word `include` in the list of blocks that `opener`
  /// began (null on the top level), and goes on with the first word of that file. Where that cannot
  /// be done, which is reported, it goes on behind the name. False where there is no name and
  /// what stands there cannot be read either.
  bool Include(const Token& include, const Token* opener);

  /// Whether another file included the one that is being read,
  bool IsIncluded() const { return files_.size() > 1; }
  /// and that in the list that `opener` began.
  bool IsIncludedIn(const Token* opener) const;
  /// Goes back to the file that included this one.
  void Leave() { files_.pop_back(); }

  /// The files that were included, each once.
  const std::vector<std::filesystem::path>& included() const { return included_; }

 private:
  struct OpenFile {
    std::filesystem::path path;
    std::filesystem::path place;  ///< Behind links and detours.
    Token opener;                 ///< Of the list that it was included in; the end on top level.
    std::shared_ptr<const std::string> text;  ///< Null for the scene file.
    Tokenizer tokens;
  };

  void Open(const std::filesystem::path& path, const SourceLocation& asked, const Token* opener);
  /// "a.txt -> b.txt -> a.txt" when the file is open already, else nothing.
  std::string CircleTo(const std::filesystem::path& place, const std::filesystem::path& path) const;

  std::vector<OpenFile> files_;  ///< Innermost last.
  std::vector<std::filesystem::path> included_;
  std::set<std::filesystem::path> places_;  ///< Of `included_`.
  size_t includes_ = 0;
  Diagnostics& diagnostics_;
};

}  // namespace candela
