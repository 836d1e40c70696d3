#include "loaders/text/line_tokenizer.h"

namespace candela {
namespace {

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

bool EndsWord(char c) {
  return IsBlank(c) || c == '\n' || c == '#';
}

}  // namespace

LineTokenizer::LineTokenizer(std::string_view text) : text_(text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
}

Token LineTokenizer::NextLine() {
  if (at_ != line_start_) LeaveLine();
  while (true) {
    const Token token = NextWord();
    if (token.IsWord() || !LeaveLine()) return token;
  }
}

Token LineTokenizer::NextWord() {
  SkipBlanks();
  Token token = TokenHere();
  const size_t start = at_;
  for (; at_ < text_.size() && !EndsWord(text_[at_]); ++at_) {
    if (text_[at_] == '\\' && ContinuationAt(at_) > 0) break;
  }
  if (at_ == start) return token;
  token.kind = Token::Kind::kWord;
  token.text = text_.substr(start, at_ - start);
  return token;
}

Token LineTokenizer::NextName() {
  SkipBlanks();
  Token token = TokenHere();
  const size_t start = at_;
  size_t end = at_;
  for (; at_ < text_.size() && text_[at_] != '\n' && ContinuationAt(at_) == 0; ++at_) {
    if (text_[at_] == '#' && (at_ == start || IsBlank(text_[at_ - 1]))) break;
    if (!IsBlank(text_[at_])) end = at_ + 1;
  }
  if (end == start) return token;
  token.kind = Token::Kind::kWord;
  token.text = text_.substr(start, end - start);
  return token;
}

Token LineTokenizer::TokenHere() const {
  Token token;
  token.line = line_;
  token.column = static_cast<uint32_t>(at_ - line_start_ + 1);
  return token;
}

void LineTokenizer::SkipBlanks() {
  while (at_ < text_.size()) {
    if (IsBlank(text_[at_])) {
      ++at_;
    } else if (const size_t length = ContinuationAt(at_)) {
      StartLine(at_ + length);
    } else {
      return;
    }
  }
}

bool LineTokenizer::LeaveLine() {
  // Word by word, since the line may be continued; a comment behind the last word is not.
  while (NextWord().IsWord()) {
  }
  const size_t end = text_.find('\n', at_);
  if (end == std::string_view::npos) {
    at_ = text_.size();
    return false;
  }
  StartLine(end + 1);
  return true;
}

void LineTokenizer::StartLine(size_t at) {
  at_ = line_start_ = at;
  ++line_;
}

/// The length of a backslash and the line end (or end of the text) behind it; 0 for anything else.
size_t LineTokenizer::ContinuationAt(size_t at) const {
  const std::string_view rest = text_.substr(at, 3);
  if (!rest.starts_with('\\')) return 0;
  if (rest == "\\" || rest.starts_with("\\\n")) return rest.size() == 1 ? 1 : 2;
  return rest == "\\\r\n" ? 3 : 0;
}

}  // namespace candela
