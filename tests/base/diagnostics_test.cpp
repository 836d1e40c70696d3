#include "base/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

SourceLocation At(const std::string& file, uint32_t line = 0, uint32_t column = 0) {
  return {std::make_shared<const std::string>(file), line, column};
}

TEST(Diagnostics, SaysWhereAndWhat) {
  Diagnostics diagnostics;
  diagnostics.Error(At("arch.txt", 44, 21), "'radius' expects a positive number, found '-1'");
  diagnostics.Warning(At("arch.txt"), "no light");
  diagnostics.Error({}, "nothing to do");
  EXPECT_THAT(diagnostics.Lines(),
              ElementsAre("arch.txt:44:21: error: 'radius' expects a positive number, found '-1'",
                          "arch.txt: warning: no light", "error: nothing to do"));
  EXPECT_EQ(diagnostics.ErrorCount(), 2u);
  EXPECT_EQ(diagnostics.WarningCount(), 1u);
}

TEST(Diagnostics, WarningsAreNotErrors) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Warning(At("a"), "odd");
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Error(At("a"), "wrong");
  EXPECT_TRUE(diagnostics.HasErrors());
}

TEST(Diagnostics, ShowsTwentyErrorsAndTwentyWarningsOfEachFileThenCounts) {
  Diagnostics diagnostics;
  for (uint32_t i = 1; i <= 22; ++i) {
    diagnostics.Error(At("a", i, 1), "e");
    diagnostics.Warning(At("a", i, 1), "w");
    if (i <= 20) diagnostics.Error(At("b", i, 1), "e");
    if (i <= 21) diagnostics.Warning(At("b", i, 1), "w");
  }
  const auto lines = diagnostics.Lines();
  ASSERT_THAT(lines, SizeIs(80 + 3));
  EXPECT_EQ(lines[78], "b:20:1: error: e");
  EXPECT_THAT(std::vector(lines.begin() + 80, lines.end()),
              ElementsAre("a: 2 more errors", "a: 2 more warnings", "b: 1 more warning"));
  EXPECT_EQ(diagnostics.ErrorCount(), 42u);
}

TEST(Diagnostics, IsFullOnceAFileHasShownItsErrors) {
  Diagnostics diagnostics;
  for (int i = 0; i < 19; ++i) diagnostics.Error(At("a"), "e");
  EXPECT_FALSE(diagnostics.IsFull(At("a", 7)));
  diagnostics.Error(At("a"), "e");
  EXPECT_TRUE(diagnostics.IsFull(At("a", 7)));
  EXPECT_FALSE(diagnostics.IsFull(At("b")));
}

TEST(Diagnostics, AppendKeepsOrderAndCounts) {
  Diagnostics first, second;
  for (int i = 0; i < 15; ++i) first.Error(At("a"), "first");
  for (int i = 0; i < 25; ++i) second.Error(At("a"), "second");
  second.Warning(At("b", 1, 2), "odd");
  first.Append(second);
  EXPECT_EQ(first.ErrorCount(), 40u);
  EXPECT_EQ(first.WarningCount(), 1u);
  const auto lines = first.Lines();
  ASSERT_THAT(lines, SizeIs(20 + 1 + 1));
  EXPECT_EQ(lines[14], "a: error: first");
  EXPECT_EQ(lines[15], "a: error: second");
  EXPECT_EQ(lines[20], "b:1:2: warning: odd");
  EXPECT_EQ(lines[21], "a: 20 more errors");
}

TEST(Diagnostics, LinesAreShortAndPrintable) {
  Diagnostics diagnostics;
  diagnostics.Error(At("a\x1b[2J"), std::string(1000, 'x') + "\n");
  for (int i = 0; i < 21; ++i) diagnostics.Error(At(std::string(1000, 'f'), 1, 2), "the reason");
  diagnostics.Error(At("c"), "two\nlines");
  const auto lines = diagnostics.Lines();
  for (const std::string& line : lines) EXPECT_LT(line.size(), 500u);
  EXPECT_EQ(lines[0].substr(0, 20), "a\\x1b[2J: error: xxx");
  EXPECT_THAT(lines[1], testing::EndsWith("ff:1:2: error: the reason"));
  EXPECT_THAT(lines[1], testing::StartsWith("..."));
  EXPECT_EQ(lines[21], "c: error: two\\x0alines");
  EXPECT_THAT(lines.back(), testing::EndsWith("ff: 1 more error"));
}

TEST(Diagnostics, StartsEmpty) {
  EXPECT_THAT(Diagnostics().Lines(), IsEmpty());
}

TEST(Diagnostics, ShowsEachFileInReadingOrder) {
  Diagnostics diagnostics;
  diagnostics.Error(At("b"), "something is missing");
  diagnostics.Error(At("a", 2, 1), "e");
  diagnostics.Error(At("b", 9, 1), "e");
  diagnostics.Warning(At("b", 3, 7), "w");
  diagnostics.Error(At("b", 3, 2), "first");
  diagnostics.Error(At("b", 3, 2), "second");
  EXPECT_THAT(diagnostics.Lines(),
              ElementsAre("b:3:2: error: first", "b:3:2: error: second", "b:3:7: warning: w",
                          "b:9:1: error: e", "b: error: something is missing", "a:2:1: error: e"));
}

TEST(Diagnostics, MakesOnlyTheTextsThatAreShown) {
  Diagnostics diagnostics;
  int made = 0;
  for (int i = 0; i < 25; ++i) {
    diagnostics.Error(At("a", 1, 1), [&] { return std::to_string(++made); });
  }
  EXPECT_EQ(made, 20);
  EXPECT_EQ(diagnostics.ErrorCount(), 25u);
  EXPECT_EQ(diagnostics.Lines()[19], "a:1:1: error: 20");
}

TEST(Diagnostics, TellWhatTheErrorsAreAbout) {
  Diagnostics diagnostics, other;
  EXPECT_EQ(diagnostics.Code(), ErrorCode::kInput);
  other.Error(At("a", 1, 1), "no room", ErrorCode::kResources);
  other.Error(At("a", 1, 1), "and wrong");
  diagnostics.Append(other);
  EXPECT_EQ(diagnostics.Code(), ErrorCode::kResources);
}

TEST(Diagnostics, PassOnTheFirstError) {
  Diagnostics diagnostics;
  diagnostics.Warning(At("a", 1, 1), "odd");
  EXPECT_TRUE(diagnostics.FirstError());
  diagnostics.Error(At("a", 3, 2), "wrong");
  diagnostics.Error(At("a", 1, 1), "wrong too");
  ASSERT_FALSE(diagnostics.FirstError());
  EXPECT_EQ(diagnostics.FirstError().error().message, "a:3:2: wrong");
}

}  // namespace
}  // namespace candela
