#include "base/text.h"

#include <gtest/gtest.h>

#include <array>

namespace candela {
namespace {

TEST(EscapeControl, KeepsWhatATerminalShows) {
  EXPECT_EQ(EscapeControl("plain text"), "plain text");
  EXPECT_EQ(EscapeControl("é€😀"), "é€😀");
  EXPECT_EQ(EscapeControl(""), "");
}

TEST(EscapeControl, WritesTheRestInHexadecimal) {
  EXPECT_EQ(EscapeControl(std::string_view("\0\t\n\x1b\x7f", 5)), "\\x00\\x09\\x0a\\x1b\\x7f");
  EXPECT_EQ(EscapeControl("\xc2\x9b"), "\\xc2\\x9b");                    // a control beyond ASCII
  EXPECT_EQ(EscapeControl("\xff"), "\\xff");                             // never in UTF-8
  EXPECT_EQ(EscapeControl("\xe2\x82"), "\\xe2\\x82");                    // cut short
  EXPECT_EQ(EscapeControl("\xc0\x80"), "\\xc0\\x80");                    // overlong
  EXPECT_EQ(EscapeControl("\xe0\x80\x80"), "\\xe0\\x80\\x80");           // overlong
  EXPECT_EQ(EscapeControl("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half of a surrogate pair
  EXPECT_EQ(EscapeControl("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
}

TEST(CutTo, CountsTheDots) {
  EXPECT_EQ(CutTo(5, "12345"), "12345");
  EXPECT_EQ(CutTo(5, "123456"), "12...");
  EXPECT_EQ(CutTo(0, ""), "");
}

TEST(CutTo, NeverCutsInsideACharacter) {
  EXPECT_EQ(CutTo(7, "abcé78"), "abcé78");
  EXPECT_EQ(CutTo(7, "abcé789"), "abc...");
  EXPECT_EQ(CutTo(8, "abcé7890"), "abcé...");
}

TEST(Quote, CutsLongTokensAtSixtyCharacters) {
  EXPECT_EQ(Quote("radius"), "'radius'");
  EXPECT_EQ(Quote(""), "''");
  EXPECT_EQ(Quote(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(Quote(std::string(61, 'x')), "'" + std::string(57, 'x') + "...'");
  EXPECT_EQ(Quote(std::string(1 << 20, 'x')), "'" + std::string(57, 'x') + "...'");
  EXPECT_EQ(Quote(std::string(100, '\n')).size(), 62u);
}

constexpr auto kWords =
    std::to_array<std::string_view>({"sphere", "plane", "triangle", "mesh", "shininess", "up"});

TEST(Nearest, FindsSpellingMistakes) {
  EXPECT_EQ(Nearest("spere", kWords), "sphere");         // a letter missing
  EXPECT_EQ(Nearest("planne", kWords), "plane");         // one too many
  EXPECT_EQ(Nearest("shinyness", kWords), "shininess");  // another one
  EXPECT_EQ(Nearest("tirangle", kWords), "triangle");    // two swapped
  EXPECT_EQ(Nearest("Mesh", kWords), "mesh");
}

TEST(Nearest, DoesNotGuessWildly) {
  for (const char* word : {"", "x", "torus", "cylinder", "zz"}) {
    EXPECT_EQ(Nearest(word, kWords), std::nullopt) << word;
  }
  EXPECT_EQ(Nearest(std::string(1 << 20, 's'), kWords), std::nullopt);
  EXPECT_EQ(Nearest("sphere", {}), std::nullopt);
}

TEST(DidYouMean, IsAPhraseOrNothing) {
  EXPECT_EQ(DidYouMean("spere", kWords), " (did you mean 'sphere'?)");
  EXPECT_EQ(DidYouMean("cylinder", kWords), "");
}

TEST(ListOf, ReadsAsASentence) {
  const std::span<const std::string_view> words = kWords;
  EXPECT_EQ(ListOf({}), "");
  EXPECT_EQ(ListOf(words.first(1)), "'sphere'");
  EXPECT_EQ(ListOf(words.first(2)), "'sphere' or 'plane'");
  EXPECT_EQ(ListOf(words.first(3)), "'sphere', 'plane' or 'triangle'");
}

TEST(Nearest, UpperAndLowerCaseAreNear) {
  constexpr std::string_view kNames[] = {"up", "fov", "FOVEA"};
  EXPECT_EQ(Nearest("FOV", kNames), "fov");
  EXPECT_EQ(Nearest("UP", kNames), "up");
  EXPECT_EQ(Nearest("XYZ", kNames), std::nullopt);
}

TEST(ListOf, EndsWithTheWordOfTheSentence) {
  constexpr std::string_view kNames[] = {"a", "b", "c"};
  EXPECT_EQ(ListOf(kNames), "'a', 'b' or 'c'");
  EXPECT_EQ(ListOf(kNames, "and"), "'a', 'b' and 'c'");
}

}  // namespace
}  // namespace candela
