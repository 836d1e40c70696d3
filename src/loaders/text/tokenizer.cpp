#include "loaders/text/tokenizer.h"

#include <utility>

#include "base/text.h"

namespace candela {
namespace {

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

bool EndsWord(char c) {
  return IsBlank(c) || c == '{' || c == '}' || c == '#';
}

}  // namespace

Tokenizer::Tokenizer(std::shared_ptr<const std::string> file, std::string_view text, uint32_t index)
    : file_(std::move(file)), text_(text), index_(index) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  for (Token& token : ahead_) token = Scan();
}

Token Tokenizer::Next() {
  return std::exchange(ahead_[0], std::exchange(ahead_[1], Scan()));
}

void Tokenizer::SkipBlanks() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '#') {
      // Stop before the line end, which the next turn counts.
      const size_t end = text_.find('\n', at_);
      at_ = (end == std::string_view::npos ? text_.size() : end) - 1;
    } else if (c == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    } else if (!IsBlank(c)) {
      return;
    }
  }
}

Token Tokenizer::Scan() {
  SkipBlanks();
  Token token;
  token.line = line_;
  token.column = static_cast<uint32_t>(at_ - line_start_ + 1);
  token.file = index_;
  if (at_ == text_.size()) return token;

  const size_t start = at_++;
  if (text_[start] == '{') {
    token.kind = Token::Kind::kOpenBrace;
  } else if (text_[start] == '}') {
    token.kind = Token::Kind::kCloseBrace;
  } else {
    token.kind = Token::Kind::kWord;
    while (at_ < text_.size() && !EndsWord(text_[at_])) ++at_;
  }
  token.text = text_.substr(start, at_ - start);
  return token;
}

std::string Describe(const Token& token) {
  return token.IsEnd() ? "the end of the file" : Quote(token.text);
}

}  // namespace candela
