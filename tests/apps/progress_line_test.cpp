#include "driver/progress_line.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(ProgressText, ShowsPercentageRateAndTimeLeft) {
  EXPECT_EQ(ProgressText({0.25, 3000000, 2}), "25%  1.5 Mrays/s  6.0 s left");
  EXPECT_EQ(ProgressText({0.01, 1500, 1}), "1%  1.5 krays/s  1 min 39 s left");
  EXPECT_EQ(ProgressText({0.001, 10, 10}), "0%  1 rays/s  2 h 46 min left");
  EXPECT_EQ(ProgressText({1e-09, 10, 10}), "0%  1 rays/s  ages left");
}

TEST(ProgressText, KnowsNoTimeLeftBeforeTheFirstSample) {
  EXPECT_EQ(ProgressText({0.0, 0, 0}), "0%");
  EXPECT_EQ(ProgressText({0.0, 0, 1}), "0%  0 rays/s");
}

// 99.999 percent is not done; all of it is, and then the time that it took counts.
TEST(ProgressText, SaysOneHundredOnlyAtTheEnd) {
  EXPECT_EQ(ProgressText({0.99999, 1, 1}).substr(0, 3), "99%");
  EXPECT_EQ(ProgressText({1.0, 3000000, 20}), "100%  150.0 krays/s  in 20 s");
}

TEST(ProgressBar, FillsTheLine) {
  EXPECT_EQ(ProgressBar({0.5, 0, 0}, 32, false), "[#############.............] 50%");
  for (const int columns : {5, 20, 40, 79, 200}) {
    EXPECT_EQ(ProgressBar({0.25, 3000000, 2}, columns, false).size(), static_cast<size_t>(columns));
  }
}

TEST(ProgressBar, GivesWayToTheTextInANarrowTerminal) {
  EXPECT_EQ(ProgressBar({0.25, 3000000, 2}, 30, false), "25%  1.5 Mrays/s  6.0 s left  ");
  EXPECT_EQ(ProgressBar({0.25, 3000000, 2}, 8, false), "25%  1.5");
  EXPECT_EQ(ProgressBar({0.25, 3000000, 2}, 0, false), "");
}

TEST(ProgressBar, ColoursAddOnlyEscapeSequences) {
  const ProgressState state{0.25, 3000000, 2};
  std::string coloured = ProgressBar(state, 79, true);
  EXPECT_EQ(coloured.substr(0, 5), "\x1b[32m");
  for (const std::string sequence : {"\x1b[32m", "\x1b[0m"}) {
    const size_t at = coloured.find(sequence);
    ASSERT_NE(at, std::string::npos);
    coloured.erase(at, sequence.size());
  }
  EXPECT_EQ(coloured, ProgressBar(state, 79, false));
}

}  // namespace
}  // namespace candela
