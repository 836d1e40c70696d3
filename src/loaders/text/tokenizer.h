#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/source_location.h"

namespace candela {

/// A word of a text and where it stands. The text is owned by whoever made the tokenizer.
struct Token {
  enum class Kind { kWord, kOpenBrace, kCloseBrace, kEnd };
  Kind kind = Kind::kEnd;
  std::string_view text;
  uint32_t line = 0;
  uint32_t column = 0;  ///< In bytes, counted from 1; a byte order mark does not count.
  uint32_t file = 0;    ///< As its tokenizer was told.

  bool IsWord() const { return kind == Kind::kWord; }
  bool IsOpenBrace() const { return kind == Kind::kOpenBrace; }
  bool IsCloseBrace() const { return kind == Kind::kCloseBrace; }
  bool IsEnd() const { return kind == Kind::kEnd; }
};

/// Cuts a scene text into words. White space separates words; braces are words of their own without
/// any around them; `#` starts a comment that ends with the line. A byte order mark at the start is
/// skipped. The text must not hold a NUL byte (see `HasNul`).
class Tokenizer {
 public:
  /// `index` marks the tokens, for whoever reads several files.
  Tokenizer(std::shared_ptr<const std::string> file, std::string_view text, uint32_t index = 0);

  /// The next token; once at the end, the end again and again.
  Token Next();
  const Token& Peek() const { return ahead_[0]; }
  /// The one behind it.
  const Token& PeekSecond() const { return ahead_[1]; }

  SourceLocation Where(const Token& token) const { return {file_, token.line, token.column}; }

 private:
  Token Scan();
  void SkipBlanks();

  std::shared_ptr<const std::string> file_;
  std::string_view text_;
  uint32_t index_;
  size_t at_ = 0;
  size_t line_start_ = 0;
  uint32_t line_ = 1;
  std::array<Token, 2> ahead_;
};

/// For messages: the token in quotes, or "the end of the file".
std::string Describe(const Token& token);

}  // namespace candela
