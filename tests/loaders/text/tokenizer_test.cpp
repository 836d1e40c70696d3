#include "loaders/text/tokenizer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// All tokens as "line:column text".
std::vector<std::string> Tokens(std::string_view text) {
  Tokenizer tokens(nullptr, text);
  std::vector<std::string> all;
  for (Token token = tokens.Next(); !token.IsEnd(); token = tokens.Next()) {
    all.push_back(fmt::format("{}:{} {}", token.line, token.column, token.text));
  }
  return all;
}

TEST(Tokenizer, WhiteSpaceSeparatesWords) {
  EXPECT_THAT(Tokens(" a\tb\v\fc\n\n  d"), ElementsAre("1:2 a", "1:4 b", "1:7 c", "3:3 d"));
}

TEST(Tokenizer, BracesAreWordsOfTheirOwn) {
  EXPECT_THAT(Tokens("Node{radius 1}}x{"), ElementsAre("1:1 Node", "1:5 {", "1:6 radius", "1:13 1",
                                                       "1:14 }", "1:15 }", "1:16 x", "1:17 {"));
}

TEST(Tokenizer, CommentsEndWithTheLine) {
  EXPECT_THAT(Tokens("#\n# { }\na# b\n}#c#d\ne"), ElementsAre("3:1 a", "4:1 }", "5:1 e"));
  EXPECT_THAT(Tokens("#"), IsEmpty());
  EXPECT_THAT(Tokens("a#"), ElementsAre("1:1 a"));
}

TEST(Tokenizer, LineEndsOfAllSystemsCountOnce) {
  EXPECT_THAT(Tokens("a\r\nb # c\r\n  d\r\n"), ElementsAre("1:1 a", "2:1 b", "3:3 d"));
}

TEST(Tokenizer, ByteOrderMarkTakesNoColumn) {
  EXPECT_THAT(Tokens("\xEF\xBB\xBF"
                     "a"),
              ElementsAre("1:1 a"));
  EXPECT_THAT(Tokens("\xEF\xBB\xBF"), IsEmpty());
  EXPECT_THAT(Tokens("a \xEF\xBB\xBF"), ElementsAre("1:1 a", "1:3 \xEF\xBB\xBF"));
}

TEST(Tokenizer, KnowsItsKinds) {
  Tokenizer tokens(nullptr, "w{}");
  EXPECT_TRUE(tokens.Next().IsWord());
  EXPECT_TRUE(tokens.Next().IsOpenBrace());
  EXPECT_TRUE(tokens.Next().IsCloseBrace());
  EXPECT_TRUE(tokens.Next().IsEnd());
  EXPECT_TRUE(tokens.Next().IsEnd());
}

TEST(Tokenizer, SeesTwoTokensAhead) {
  Tokenizer tokens(nullptr, "a b");
  EXPECT_EQ(tokens.Peek().text, "a");
  EXPECT_EQ(tokens.PeekSecond().text, "b");
  EXPECT_EQ(tokens.Next().text, "a");
  EXPECT_EQ(tokens.Peek().text, "b");
  EXPECT_TRUE(tokens.PeekSecond().IsEnd());
}

TEST(Tokenizer, PlacesNameTheFile) {
  Tokenizer tokens(std::make_shared<const std::string>("a.txt"), "\n x");
  EXPECT_EQ(ToString(tokens.Where(tokens.Peek())), "a.txt:2:2");
}

TEST(Describe, QuotesWordsAndNamesTheEnd) {
  Tokenizer tokens(nullptr, "w");
  EXPECT_EQ(Describe(tokens.Next()), "'w'");
  EXPECT_EQ(Describe(tokens.Next()), "the end of the file");
}

}  // namespace
}  // namespace candela
