#include "driver/arg_parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace candela {
namespace {

using testing::HasSubstr;

/// A parser with one option of each kind, and what it reads.
struct Fixture {
  explicit Fixture(ArgStyle style) : parser("prog", "Does things.", style) {
    parser.Group("Things");
    parser.Option("size", {Whole("W", &width, 1), Whole("H", &height, 1)}, "sides");
    parser.Option("depth", {Real("MIN", &min), Real("MAX", &max), File("FILE", &depth)}, "range");
    parser.Option("output", {File("FILE", &output)}, "picture", {.letter = 'o'});
    parser.Option("filter", {Choice("NAME", &filter, {"box", "tent"})}, "weights");
    parser.Flag("shadows", &shadows, "dark", {.letter = 's'});
  }

  /// The message of the error, or nothing when there is none.
  std::string Read(const std::vector<const char*>& words) {
    const auto outcome = parser.Parse(words);
    if (outcome) return "";
    EXPECT_EQ(outcome.error().code, ErrorCode::kUsage);
    return outcome.error().message;
  }

  ArgParser parser;
  int width = 0, height = 0;
  float min = 0, max = 0;
  std::filesystem::path depth, output;
  std::string filter;
  bool shadows = false;
};

std::string CourseMessage(const std::vector<const char*>& words) {
  return Fixture(ArgStyle::kCourse).Read(words);
}

std::string GnuMessage(const std::vector<const char*>& words) {
  return Fixture(ArgStyle::kGnu).Read(words);
}

TEST(ArgParser, ReadsTheStyleOfTheCourse) {
  Fixture f(ArgStyle::kCourse);
  EXPECT_EQ(f.Read({"-size", "30", "+20", "-shadows", "-output", "a.png"}), "");
  EXPECT_EQ(f.width, 30);
  EXPECT_EQ(f.height, 20);
  EXPECT_EQ(f.output, "a.png");
  EXPECT_TRUE(f.shadows);
  EXPECT_TRUE(f.parser.Has("size"));
  EXPECT_FALSE(f.parser.Has("depth"));
}

TEST(ArgParser, ReadsTheStyleOfGnu) {
  Fixture f(ArgStyle::kGnu);
  EXPECT_EQ(f.Read({"--size=30", "20", "-s", "-oa.png", "--filter=tent"}), "");
  EXPECT_EQ(f.width, 30);
  EXPECT_EQ(f.height, 20);
  EXPECT_EQ(f.output, "a.png");
  EXPECT_EQ(f.filter, "tent");
  EXPECT_TRUE(f.shadows);
}

TEST(ArgParser, TwoDashesAreFineInTheStyleOfTheCourse) {
  Fixture f(ArgStyle::kCourse);
  EXPECT_EQ(f.Read({"--size", "3", "4", "-output=-x.png"}), "");
  EXPECT_EQ(f.height, 4);
  EXPECT_EQ(f.output, "-x.png");
}

TEST(ArgParser, NegativeNumbersAreValues) {
  Fixture f(ArgStyle::kCourse);
  EXPECT_EQ(f.Read({"-depth", "-1", "-.5", "d.png"}), "");
  EXPECT_EQ(f.min, -1.0f);
  EXPECT_EQ(f.max, -0.5f);
}

TEST(ArgParser, SaysWhichValueIsNotWhatItShouldBe) {
  EXPECT_EQ(CourseMessage({"-size", "800", "0x10"}),
            "-size: expects a whole number from 1 to 2147483647 for H, found '0x10'");
  EXPECT_EQ(CourseMessage({"-size", "0", "10"}),
            "-size: expects a whole number from 1 to 2147483647 for W, found '0'");
  EXPECT_EQ(GnuMessage({"--size", "1.5", "10"}),
            "--size: expects a whole number from 1 to 2147483647 for W, found '1.5'");
  EXPECT_EQ(CourseMessage({"-depth", "1", "nan", "d.png"}),
            "-depth: expects a number for MAX, found 'nan'");
  EXPECT_EQ(GnuMessage({"--output="}), "--output: expects the name of a file, found ''");
  EXPECT_EQ(GnuMessage({"--filter", "tnet"}),
            "--filter: expects 'box' or 'tent', found 'tnet' (did you mean 'tent'?)");
}

TEST(ArgParser, SaysWhatIsMissing) {
  EXPECT_EQ(CourseMessage({"-output"}), "-output: expects FILE, found nothing");
  EXPECT_EQ(CourseMessage({"-size", "5"}), "-size: expects W H, found only '5'");
  EXPECT_EQ(CourseMessage({"-size", "5", "-shadows"}),
            "-size: expects W H, found only '5' before '-shadows'");
  EXPECT_EQ(CourseMessage({"-depth", "5", "6"}),
            "-depth: expects MIN MAX FILE, found only 2 of 3 values");
  EXPECT_EQ(CourseMessage({"-output", "-shadows"}),
            "-output: expects FILE, found nothing before '-shadows'");
  EXPECT_EQ(GnuMessage({"--output", "-x.png"}),
            "--output: expects FILE, found nothing before '-x.png' (if that is meant as a value, "
            "write --output=-x.png)");
}

TEST(ArgParser, SuggestsTheOptionThatWasProbablyMeant) {
  EXPECT_EQ(CourseMessage({"-shadow"}), "unknown option '-shadow' (did you mean '-shadows'?)");
  EXPECT_EQ(GnuMessage({"--outptu=x"}), "unknown option '--outptu' (did you mean '--output'?)");
  EXPECT_EQ(GnuMessage({"-size", "1", "1"}), "unknown option '-size' (did you mean '--size'?)");
  EXPECT_EQ(CourseMessage({"-xyz"}), "unknown option '-xyz'");
}

TEST(ArgParser, OptionsWithValuesAreGivenOnceFlagsAsOftenAsOneLikes) {
  EXPECT_EQ(CourseMessage({"-output", "a", "-output", "b"}), "-output is given twice");
  EXPECT_EQ(GnuMessage({"-oa", "--output", "b"}), "--output is given twice");
  EXPECT_EQ(CourseMessage({"-shadows", "-shadows"}), "");
}

TEST(ArgParser, FlagsTakeNoValue) {
  EXPECT_EQ(GnuMessage({"--shadows=no"}), "--shadows: takes no value, found 'no'");
}

TEST(ArgParser, WordsWithoutAnOptionAreRefused) {
  EXPECT_EQ(CourseMessage({"output"}), "unexpected argument 'output' (did you mean '-output'?)");
  EXPECT_EQ(CourseMessage({"-size", "1", "2", "3"}), "unexpected argument '3' after -size W H");
}

TEST(ArgParser, ControlCharactersAreEscapedAndLongWordsCut) {
  const std::string longword(1000, 'x');
  const std::string message = CourseMessage({"-filter", longword.c_str()});
  EXPECT_LT(message.size(), 120u);
  EXPECT_THAT(CourseMessage({"-filter", "\x1b[2J"}), HasSubstr("found '\\x1b[2J'"));
}

TEST(ArgParser, RequiredOnesMustBeThere) {
  std::filesystem::path file;
  ArgParser parser("prog", "", ArgStyle::kCourse);
  parser.Group("All");
  parser.Option("input", {File("FILE", &file)}, "scene", {.required = true});
  EXPECT_EQ(parser.Parse({}).error().message, "-input FILE is missing");
}

TEST(ArgParser, PositionalsComeInOrderAndTheLastMayRepeat) {
  std::filesystem::path out;
  std::vector<std::filesystem::path> in;
  bool flag = false;
  const auto parse = [&](std::vector<const char*> words) {
    ArgParser parser("prog", "", ArgStyle::kGnu);
    parser.Group("All");
    parser.Flag("flag", &flag, "");
    parser.Positional(File("OUT", &out), "");
    parser.PositionalList(File("IN", &in), "");
    const auto outcome = parser.Parse(words);
    return outcome ? std::string() : outcome.error().message;
  };
  EXPECT_EQ(parse({}), "OUT is missing");
  EXPECT_EQ(parse({"o"}), "IN is missing");
  EXPECT_EQ(parse({"o", "", "b"}), "IN: expects the name of a file, found ''");
  in.clear();
  EXPECT_EQ(parse({"o", "a", "--flag", "--", "--flag", "-x"}), "");
  EXPECT_EQ(out, "o");
  EXPECT_THAT(in, testing::ElementsAre("a", "--flag", "-x"));
}

TEST(ArgParser, AnOptionalListMayBeEmpty) {
  std::vector<std::filesystem::path> in;
  ArgParser parser("prog", "", ArgStyle::kGnu);
  parser.OptionalList(File("IN", &in), "");
  EXPECT_TRUE(parser.Parse({}).ok());
  EXPECT_THAT(in, testing::IsEmpty());
  EXPECT_THAT(parser.Help(), testing::StartsWith("Usage: prog [IN...] [options]\n"));
  EXPECT_TRUE(parser.Parse(std::vector{"a", "b"}).ok());
  EXPECT_THAT(in, testing::ElementsAre("a", "b"));
}

TEST(ArgParser, HelpAndVersionWinOverErrors) {
  Fixture course(ArgStyle::kCourse), gnu(ArgStyle::kGnu);
  using enum ArgParser::Outcome;
  const auto ask = [](Fixture& f, std::vector<const char*> words) {
    return *f.parser.Parse(words);
  };
  EXPECT_EQ(ask(course, {"-nonsense", "-help"}), kShowHelp);
  EXPECT_EQ(ask(course, {"-output", "--help"}), kShowHelp);
  EXPECT_EQ(ask(course, {"-version"}), kShowVersion);
  EXPECT_EQ(ask(gnu, {"-h"}), kShowHelp);
  EXPECT_EQ(ask(gnu, {"--nonsense", "--version"}), kShowVersion);
}

TEST(ArgParser, HelpShowsEveryOptionInLinesOfEightyCharacters) {
  const Fixture f(ArgStyle::kGnu);
  const std::string help = f.parser.Help();
  for (const char* label :
       {"Usage: prog [options]\n", "Things:\n", "  --size W H ", "  --depth MIN MAX FILE ",
        "  -o, --output FILE ", "  --filter NAME ", "  -s, --shadows ", "  -h, --help "}) {
    EXPECT_THAT(help, HasSubstr(label));
  }
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST(Whole, TargetsMayBeOptionalAndRangesAreClosed) {
  std::optional<uint32_t> number;
  const ArgValue value = Whole("N", &number, 0, 4294967295);
  EXPECT_FALSE(value.store("-1"));
  EXPECT_FALSE(value.store("4294967296"));
  EXPECT_FALSE(value.store("18446744073709551616"));
  EXPECT_EQ(number, std::nullopt);
  EXPECT_TRUE(value.store("4294967295"));
  EXPECT_EQ(number, 4294967295u);
  EXPECT_TRUE(value.store("0"));
  EXPECT_EQ(number, 0u);
}

}  // namespace
}  // namespace candela
