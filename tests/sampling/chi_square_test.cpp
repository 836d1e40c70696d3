// The yardstick itself: it accepts what is right and rejects what is a little wrong.

#include "tests/sampling/chi_square.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

constexpr size_t kCells = 1000;
constexpr int kSamples = 1000000;

/// Counts of samples whose density is 1 + excess in every other cell, and 1 - excess between.
std::vector<uint64_t> Counts(double excess, uint32_t seed) {
  UniformNumbers numbers(seed);
  std::vector<uint64_t> counts(kCells);
  for (int i = 0; i < kSamples; ++i) {
    const size_t pair = static_cast<size_t>(numbers.Next() * (kCells / 2));
    ++counts[2 * pair + (numbers.Next() < 0.5 * (1 + excess) ? 0 : 1)];
  }
  return counts;
}

TEST(ChiSquare, AcceptsTheRightDensity) {
  const std::vector<double> shares(kCells, 1.0 / kCells);
  for (uint32_t seed = 0; seed < 20; ++seed) {
    EXPECT_LT(std::abs(ChiSquareDeviate(Counts(0, seed), shares)), kLargestDeviate);
  }
}

TEST(ChiSquare, RejectsADensityThatIsTwoPercentOff) {
  const std::vector<double> shares(kCells, 1.0 / kCells);
  for (uint32_t seed = 0; seed < 20; ++seed) {
    EXPECT_GT(ChiSquareDeviate(Counts(0.02, seed), shares), kLargestDeviate);
  }
}

TEST(ChiSquare, RejectsASampleWhereTheDensityIsZero) {
  EXPECT_EQ(ChiSquareDeviate(std::vector<uint64_t>{500, 500, 1}, std::vector<double>{0.5, 0.5, 0}),
            INFINITY);
}

}  // namespace
}  // namespace candela::test
