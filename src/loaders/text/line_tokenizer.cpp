#include "loaders/text/line_tokenizer.h"

#include <array>

namespace candela {
namespace {

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// By character: whether a word may end there (a backslash ends it where it continues the line). A
/// table, since this is asked for each byte of files of hundreds of megabytes.
constexpr auto kMayEndWord = [] {
  std::array<bool, 256> table{};
  for (const char c : {' ', '\t', '\r', '\v', '\f', '\n', '#', '\\'}) {
    table[static_cast<unsigned char>(c)] = true;
  }
  return table;
}();

bool MayEndWord(char c) {
  return kMayEndWord[static_cast<unsigned char>(c)];
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
  size_t end = start;
  for (; end < text_.size(); ++end) {
    if (MayEndWord(text_[end]) && (text_[end] != '\\' || ContinuationAt(end) > 0)) break;
  }
  if (end == start) return token;
  at_ = end;
  token.kind = Token::Kind::kWord;
  token.text = text_.substr(start, end - start);
  return token;
}

Token LineTokenizer::NextName() {
  SkipBlanks();
  Token token = TokenHere();
  const size_t start = at_;
  size_t end = at_;
  for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
    if (text_[at_] == '\\' && ContinuationAt(at_) > 0) break;
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
    } else if (const size_t length = text_[at_] == '\\' ? ContinuationAt(at_) : 0) {
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

/// The length of the backslash at `at` with the line end (or end of the text) behind it; 0 where it
/// is a character like others.
size_t LineTokenizer::ContinuationAt(size_t at) const {
  const std::string_view behind = text_.substr(at + 1, 2);
  if (behind.empty()) return 1;
  if (behind[0] == '\n') return 2;
  return behind == "\r\n" ? 3 : 0;
}

}  // namespace candela
