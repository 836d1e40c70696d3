#include "loaders/course/block_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "loaders/course/block_words.h"

namespace candela {
namespace {

bool IsOneOf(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool IsBlockWord(std::string_view word) {
  return IsOneOf(kSectionWords, word) || IsOneOf(kMaterialsWords, word) ||
         IsOneOf(kMediaWords, word) || IsOneOf(kTexturesWords, word) || IsOneOf(kNodeWords, word);
}

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Numbers and attempts at one. A path may look so as well; the reader of the parameter will know.
bool LooksNumeric(const Token& token) {
  constexpr std::string_view kNotFinite[] = {"nan", "NaN", "NAN", "inf", "Inf", "INF", "infinity"};
  if (!token.IsWord()) return false;
  const std::string_view word = token.text;
  if (IsDigit(word[0]) || word[0] == '+' || word[0] == '-') return true;
  return (word.size() > 1 && word[0] == '.' && IsDigit(word[1])) || IsOneOf(kNotFinite, word);
}

}  // namespace

bool BlockReader::OpenBlock(const Token& opener) {
  if (tokens_.Peek().IsOpenBrace()) {
    tokens_.Next();
    return true;
  }
  is_cut_short_ = is_cut_short_ || tokens_.Peek().IsEnd();
  diagnostics_.Error(tokens_.Where(tokens_.Peek()), [&] {
    return fmt::format("'{{' is due after {}, found {}", Quote(opener.text),
                       Describe(tokens_.Peek()));
  });
  return false;
}

Token BlockReader::NextItem(const Token* opener, std::span<const std::string_view> accepted) {
  // What follows a word that was reported belongs to the same mistake.
  bool is_reported = false;
  while (true) {
    if (tokens_.Peek().IsWord() && tokens_.Peek().text == kInclude) {
      is_reported = !tokens_.Include(tokens_.Next(), opener);
      continue;
    }
    const bool is_outside = tokens_.IsIncludedIn(opener);  // The list was opened in another file.
    if (is_outside && tokens_.Peek().IsEnd()) {
      tokens_.Leave();
      is_reported = false;
      continue;
    }
    if (opener && !is_outside && tokens_.Peek().IsEnd()) {
      EndsWithoutBrace(*opener);
      // The file that included this one goes on behind it, and has its own braces.
      Token end = tokens_.Peek();
      if (tokens_.IsIncluded()) end.kind = Token::Kind::kCloseBrace;
      return end;
    }
    if (opener && !is_outside && tokens_.PeekSecond().IsOpenBrace() &&
        IsOneOf(kSectionWords, tokens_.Peek().text)) {
      EndsWithoutBrace(*opener);
      return {};
    }
    Token token = tokens_.Next();
    if (is_outside && token.IsCloseBrace()) {
      diagnostics_.Warning(tokens_.Where(token), "this closing brace closes nothing");
      continue;
    }
    // Where an included file ends in another list than it began in, braces are wrong, and what the
    // other files have left is not read.
    has_skipped_section_ = has_skipped_section_ || (token.IsEnd() && tokens_.IsIncluded());
    if (token.IsEnd() || token.IsCloseBrace() || IsOneOf(accepted, token.text)) return token;

    const bool has_block = token.IsWord() && tokens_.Peek().IsOpenBrace();
    // A word of another place was not misspelt but misplaced.
    const auto nearest = IsBlockWord(token.text) ? std::nullopt : Nearest(token.text, accepted);
    const bool is_mended = has_block && nearest;
    if (is_mended || !is_reported) {
      diagnostics_.Error(tokens_.Where(token), [&] {
        std::vector<std::string_view> words(accepted.begin(), accepted.end());
        words.push_back(kInclude);
        return fmt::format("{} is due, found {}{}", ListOf(words), Describe(token),
                           IsBlockWord(token.text) ? "" : DidYouMean(token.text, words));
      });
    }
    is_reported = true;
    if (is_mended) {
      token.text = *nearest;
      return token;
    }
    if (has_block) tokens_.Next();
    if (has_block || token.IsOpenBrace()) {
      SkipBlock();
      has_skipped_section_ = has_skipped_section_ || !opener;
    }
  }
}

ParamSet BlockReader::ReadParams(const Token& opener, Repeats repeats, Textures textures) {
  ParamSet set;
  std::set<std::string_view> names;
  const bool is_open = OpenBlock(opener);
  set.is_damaged = !is_open;
  while (true) {
    const Token& next = tokens_.Peek();
    if (next.IsCloseBrace()) {
      tokens_.Next();
      return set;
    }
    const bool opens_block = next.IsWord() && tokens_.PeekSecond().IsOpenBrace();
    if (next.IsEnd() || (opens_block && IsBlockWord(next.text))) {
      if (is_open) EndsWithoutBrace(opener);
      set.is_damaged = true;
      return set;
    }
    if (opens_block || !next.IsWord() || LooksNumeric(next)) {
      NoParam();
      set.is_damaged = true;
      continue;
    }
    if (!names.insert(next.text).second && repeats == Repeats::kOdd) {
      diagnostics_.Warning(
          tokens_.Where(next),
          fmt::format("{} is given once more; the last one counts", Quote(next.text)));
    }
    set.params.push_back(ReadParam(textures));
  }
}

/// Reads a parameter whose name comes next.
Param BlockReader::ReadParam(Textures textures) {
  const Token name = tokens_.Next();
  Param param{std::string(name.text), tokens_.Where(name), {}};
  const auto take_word = [&] {
    const Token token = tokens_.Next();
    param.words.push_back({std::string(token.text), tokens_.Where(token)});
  };
  const auto is_word_due = [&] {
    return tokens_.Peek().IsWord() && !tokens_.PeekSecond().IsOpenBrace();
  };
  if (is_word_due()) take_word();
  // What these are is a word itself, which may well be 'texture'.
  constexpr std::string_view kWordParams[] = {"name", "type", "file"};
  const bool names_texture = textures == Textures::kByName && !param.words.empty() &&
                             param.words[0].text == "texture" && !IsOneOf(kWordParams, name.text);
  if (names_texture && is_word_due() && !LooksNumeric(tokens_.Peek())) take_word();
  while (LooksNumeric(tokens_.Peek())) take_word();
  return param;
}

/// Reports and skips what stands where the name of a parameter is due.
void BlockReader::NoParam() {
  const Token token = tokens_.Next();
  diagnostics_.Error(tokens_.Where(token), [&] {
    return fmt::format("the name of a parameter or '}}' is due, found {}", Describe(token));
  });
  const bool has_block = token.IsWord() && tokens_.Peek().IsOpenBrace();
  if (has_block) tokens_.Next();
  if (has_block || token.IsOpenBrace()) SkipBlock();
  while (LooksNumeric(tokens_.Peek())) tokens_.Next();
}

/// Reports that the closing brace of a block is missing before the next token, which cannot stand
/// in the block.
void BlockReader::EndsWithoutBrace(const Token& opener) {
  const bool was_cut_short = std::exchange(is_cut_short_, tokens_.Peek().IsEnd());
  if (was_cut_short) return;
  diagnostics_.Error(tokens_.Where(tokens_.Peek()), [&] {
    const std::string block =
        fmt::format("the block {} of line {}", Quote(opener.text), opener.line);
    return is_cut_short_ ? fmt::format("the file ends inside {}", block)
                         : fmt::format("'}}' is due before {}: {} is not closed",
                                       Describe(tokens_.Peek()), block);
  });
}

/// Goes on behind the brace that closes the one just taken.
void BlockReader::SkipBlock() {
  for (size_t depth = 1; depth > 0 && !tokens_.Peek().IsEnd();) {
    const Token token = tokens_.Next();
    if (token.IsOpenBrace()) ++depth;
    if (token.IsCloseBrace()) --depth;
  }
}

}  // namespace candela
