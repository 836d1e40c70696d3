#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "loaders/text/tokenizer.h"
#include "scene_spec/param_set.h"

namespace candela {

/// Reads the parts all blocks of a scene share: braces, and lists of named parameters.
class BlockReader {
 public:
  BlockReader(Tokenizer* tokens, Diagnostics* diagnostics)
      : tokens_(*tokens), diagnostics_(*diagnostics) {}

  /// Takes the opening brace that has to follow `opener`. When it is missing that is reported, and
  /// reading goes on as if it were there.
  void OpenBlock(const Token& opener);

  /// Reads `name value ...` pairs up to and including the closing brace of the block `opener`.
  ParamSet ReadParams(const Token& opener);

  /// Reports a word that none of `accepted` is, and skips the block behind it, if there is one.
  void UnknownWord(const Token& word, std::span<const std::string_view> accepted);

  /// Reports that the file ends inside the block that `opener` began.
  void UnexpectedEnd(const Token& opener);

 private:
  void SkipBlock();

  Tokenizer& tokens_;
  Diagnostics& diagnostics_;
};

}  // namespace candela
