#include "loaders/course/block_reader.h"

#include <fmt/format.h>

#include <string>

#include "base/text.h"

namespace candela {
namespace {

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Words that are numbers or attempts at one. A path may look so as well; that is for the reader of
/// the parameter to say.
bool LooksNumeric(std::string_view word) {
  constexpr std::string_view kNotFinite[] = {"nan", "NaN", "NAN", "inf", "Inf", "INF", "infinity"};
  for (const std::string_view each : kNotFinite) {
    if (word == each) return true;
  }
  if (IsDigit(word[0]) || word[0] == '+' || word[0] == '-') return true;
  return word.size() > 1 && word[0] == '.' && IsDigit(word[1]);
}

}  // namespace

void BlockReader::OpenBlock(const Token& opener) {
  if (tokens_.Peek().kind == Token::Kind::kOpenBrace) {
    tokens_.Next();
    return;
  }
  diagnostics_.Error(
      tokens_.Where(tokens_.Peek()),
      fmt::format("'{{' is due after {}, found {}", Quote(opener.text), Describe(tokens_.Peek())));
}

ParamSet BlockReader::ReadParams(const Token& opener) {
  ParamSet set;
  const auto is_number = [&] {
    return tokens_.Peek().IsWord() && LooksNumeric(tokens_.Peek().text);
  };
  const auto take = [&] {
    const Token token = tokens_.Next();
    return ParamWord{std::string(token.text), tokens_.Where(token)};
  };

  while (true) {
    const Token token = tokens_.Next();
    if (token.kind == Token::Kind::kCloseBrace) return set;
    if (token.IsEnd()) {
      UnexpectedEnd(opener);
      return set;
    }
    if (!token.IsWord() || LooksNumeric(token.text)) {
      diagnostics_.Error(
          tokens_.Where(token),
          fmt::format("the name of a parameter or '}}' is due, found {}", Describe(token)));
      if (!token.IsWord()) SkipBlock();
      while (is_number()) tokens_.Next();
      continue;
    }

    Param param{std::string(token.text), tokens_.Where(token), {}};
    while (is_number()) param.words.push_back(take());
    if (param.words.empty() && tokens_.Peek().IsWord()) {
      // A word followed by numbers is more likely the next parameter, and this one lacks its value.
      const Token word = tokens_.Next();
      if (is_number()) {
        set.params.push_back(std::move(param));
        param = {std::string(word.text), tokens_.Where(word), {}};
        while (is_number()) param.words.push_back(take());
      } else {
        param.words.push_back({std::string(word.text), tokens_.Where(word)});
      }
    }
    set.params.push_back(std::move(param));
  }
}

void BlockReader::UnknownWord(const Token& word, std::span<const std::string_view> accepted) {
  diagnostics_.Error(tokens_.Where(word),
                     fmt::format("{} is due, found {}{}", ListOf(accepted), Describe(word),
                                 DidYouMean(word.text, accepted)));
  if (tokens_.Peek().kind == Token::Kind::kOpenBrace || word.kind == Token::Kind::kOpenBrace) {
    if (word.kind != Token::Kind::kOpenBrace) tokens_.Next();
    SkipBlock();
  }
}

void BlockReader::SkipBlock() {
  for (size_t depth = 1; depth > 0 && !tokens_.Peek().IsEnd();) {
    const Token token = tokens_.Next();
    if (token.kind == Token::Kind::kOpenBrace) ++depth;
    if (token.kind == Token::Kind::kCloseBrace) --depth;
  }
}

void BlockReader::UnexpectedEnd(const Token& opener) {
  diagnostics_.Error(
      tokens_.Where(tokens_.Peek()),
      fmt::format("the file ends inside the block {} of line {}", Quote(opener.text), opener.line));
}

}  // namespace candela
