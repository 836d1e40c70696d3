#include "lights/ies_words.h"

#include <algorithm>

namespace candela {
namespace {

bool IsSeparator(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == ',' || c == '\n';
}

}  // namespace

IesWords::Word IesWords::WordAt(size_t start, size_t end) const {
  return {text_.substr(start, end - start), line_, static_cast<uint32_t>(start - line_start_ + 1)};
}

void IesWords::StartLine() {
  line_start_ = ++at_;
  ++line_;
}

IesWords::Word IesWords::NextLine() {
  const size_t end = std::min(text_.find('\n', at_), text_.size());
  size_t first = at_, last = end;
  while (first < last && IsSeparator(text_[first])) ++first;
  while (last > first && IsSeparator(text_[last - 1])) --last;
  const Word line = WordAt(first, last);
  at_ = end;
  if (!IsAtEnd()) StartLine();
  return line;
}

IesWords::Word IesWords::NextWord() {
  while (!IsAtEnd() && IsSeparator(text_[at_])) {
    if (text_[at_] == '\n') {
      StartLine();
    } else {
      ++at_;
    }
  }
  const size_t start = at_;
  while (!IsAtEnd() && !IsSeparator(text_[at_])) ++at_;
  return WordAt(start, at_);
}

}  // namespace candela
