#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "loaders/text/tokenizer.h"

namespace candela {

/// Cuts a text into words as `Tokenizer` does, for formats where a line is a sentence (OBJ, MTL)
/// and braces mean nothing. A backslash at the end of a line joins the next line to it. `#` starts
/// a comment, which ends with its own line: a path in a comment may well end in a backslash. A copy
/// goes on from the same place, so that a line can be read again later.
class LineTokenizer {
 public:
  /// The text must stay alive and must not hold a NUL byte (see `HasNul`).
  explicit LineTokenizer(std::string_view text);

  /// Leaves what is left of the current line; returns the first word of the next line that has one,
  /// or the end of the text.
  Token NextLine();

  /// The next word of the line; at its end a token that is no word, again and again.
  Token NextWord();

  /// What is left of the line as one word, without blanks around it: a name, which may hold blanks.
  /// In names only a `#` after a blank starts a comment.
  Token NextName();

 private:
  Token TokenHere() const;
  void SkipBlanks();
  bool LeaveLine();
  void StartLine(size_t at);
  size_t ContinuationAt(size_t at) const;

  std::string_view text_;
  size_t at_ = 0;
  size_t line_start_ = 0;
  uint32_t line_ = 1;
};

}  // namespace candela
