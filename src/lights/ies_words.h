#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace candela {

/// Cuts a photometric text into lines and these into words. White space and commas separate words;
/// the lines end in LF or CRLF.
class IesWords {
 public:
  struct Word {
    std::string_view text;  ///< Empty at the end of the file.
    uint32_t line, column;  ///< From 1; the column in bytes.
  };

  /// The text has to stay alive.
  explicit IesWords(std::string_view text) : text_(text) {}

  /// What is left of the line, without blanks around it, and goes on to the next one.
  Word NextLine();
  bool IsAtEnd() const { return at_ >= text_.size(); }
  /// The next word, in this line or a later one.
  Word NextWord();

 private:
  Word WordAt(size_t start, size_t end) const;
  void StartLine();

  std::string_view text_;
  size_t at_ = 0, line_start_ = 0;
  uint32_t line_ = 1;
};

}  // namespace candela
