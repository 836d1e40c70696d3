#include <cctype>
#include <utility>

#include "tests/layering/layering_rules.h"

namespace candela::layering {
namespace {

/// Walks over C++ source and copies what is code.
class Stripper {
 public:
  explicit Stripper(std::string_view source) : source_(source) {}

  std::string Run() {
    while (at_ < source_.size()) Step();
    return std::move(code_);
  }

 private:
  void Step() {
    if (Starts("//")) {
      DropUntil("\n", 0);
    } else if (Starts("/*")) {
      DropUntil("*/", 2);
    } else if (Starts("R\"")) {
      const size_t open = source_.find('(', at_);
      const std::string close = ")" + std::string(source_.substr(at_ + 2, open - at_ - 2)) + "\"";
      DropUntil(close, close.size());
    } else if (source_[at_] == '"' && !IsInInclude()) {
      DropQuoted('"');
    } else if (source_[at_] == '\'' && !IsDigitSeparator()) {
      DropQuoted('\'');
    } else {
      code_ += source_[at_++];
    }
  }

  bool Starts(std::string_view text) const { return source_.substr(at_).starts_with(text); }

  bool IsInInclude() const {
    const size_t line = code_.rfind('\n') + 1;  // npos + 1 is 0: the first line
    const size_t first = code_.find_first_not_of(" \t", line);
    return first != std::string::npos && code_[first] == '#';
  }

  // 1'000 and 0xFF'00 are numbers, u8'x' is rare enough to be written otherwise.
  bool IsDigitSeparator() const {
    return !code_.empty() && std::isxdigit(static_cast<unsigned char>(code_.back())) != 0;
  }

  /// Skips to the end of `text` (`length` of it included), keeping the line structure.
  void DropUntil(std::string_view text, size_t length) {
    const size_t found = source_.find(text, at_ + 2);
    const size_t end = found == std::string_view::npos ? source_.size() : found + length;
    for (; at_ < end; ++at_) {
      if (source_[at_] == '\n') code_ += '\n';
    }
  }

  void DropQuoted(char quote) {
    code_ += quote;
    for (++at_; at_ < source_.size() && source_[at_] != quote && source_[at_] != '\n'; ++at_) {
      if (source_[at_] == '\\') ++at_;
    }
    if (at_ < source_.size()) code_ += source_[at_++];
  }

  std::string_view source_;
  size_t at_ = 0;
  std::string code_;
};

}  // namespace

std::string CodeOf(std::string_view source) {
  return Stripper(source).Run();
}

}  // namespace candela::layering
