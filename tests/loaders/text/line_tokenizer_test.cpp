#include "loaders/text/line_tokenizer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Every word as "line:column word", the first ones of lines marked.
std::vector<std::string> Words(std::string_view text) {
  std::vector<std::string> words;
  LineTokenizer lines(text);
  for (Token first = lines.NextLine(); first.IsWord(); first = lines.NextLine()) {
    words.push_back(fmt::format("> {}:{} {}", first.line, first.column, first.text));
    for (Token word = lines.NextWord(); word.IsWord(); word = lines.NextWord()) {
      words.push_back(fmt::format("{}:{} {}", word.line, word.column, word.text));
    }
  }
  return words;
}

TEST(LineTokenizer, WordsKnowTheirPlace) {
  EXPECT_THAT(Words("a  b\n\n \tc{d}\r\n# e\nf"),
              ElementsAre("> 1:1 a", "1:4 b", "> 3:3 c{d}", "> 5:1 f"));
  EXPECT_THAT(Words("\xEF\xBB\xBF"
                    "a"),
              ElementsAre("> 1:1 a"));
}

TEST(LineTokenizer, ABackslashJoinsLines) {
  EXPECT_THAT(Words("a\\\nb \\\r\n c\nd"), ElementsAre("> 1:1 a", "2:1 b", "3:2 c", "> 4:1 d"));
  EXPECT_THAT(Words("a \\ b\\c \\\\\nd"),
              ElementsAre("> 1:1 a", "1:3 \\", "1:5 b\\c", "1:9 \\", "2:1 d"));
  EXPECT_THAT(Words("\\\na\\"), ElementsAre("> 2:1 a"));
}

TEST(LineTokenizer, CommentsEndWithTheirLine) {
  EXPECT_THAT(Words("a#b \\\nc # \\\r\nd"), ElementsAre("> 1:1 a", "> 2:1 c", "> 3:1 d"));
}

TEST(LineTokenizer, NextLineLeavesTheRestOfAJoinedLine) {
  LineTokenizer lines("a b \\\n c # d\ne");
  EXPECT_EQ(lines.NextLine().text, "a");
  EXPECT_EQ(lines.NextLine().text, "e");
  EXPECT_FALSE(lines.NextLine().IsWord());
  EXPECT_FALSE(lines.NextLine().IsWord());
}

TEST(LineTokenizer, NamesMayHoldBlanksAndNumberSigns) {
  LineTokenizer lines("n  dark blue#2 # c\r\nn\nn # c\nn \\\n");
  lines.NextLine();
  const Token name = lines.NextName();
  EXPECT_EQ(name.text, "dark blue#2");
  EXPECT_EQ(name.column, 4u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(lines.NextLine().text, "n");
    EXPECT_FALSE(lines.NextName().IsWord());
  }
}

TEST(LineTokenizer, ACopyGoesOnFromTheSamePlace) {
  LineTokenizer lines("a b c\nd");
  lines.NextLine();
  LineTokenizer copy = lines;
  EXPECT_EQ(lines.NextLine().text, "d");
  EXPECT_EQ(copy.NextWord().text, "b");
  EXPECT_EQ(copy.NextWord().text, "c");
  EXPECT_FALSE(copy.NextWord().IsWord());
}

TEST(LineTokenizer, NothingIsNoLine) {
  EXPECT_THAT(Words(""), IsEmpty());
  EXPECT_THAT(Words(" \n# a"), IsEmpty());
}

}  // namespace
}  // namespace candela
