#include "sampling/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

constexpr int kSamples = 1000000;

/// Values over five orders of magnitude, some of them 0, also the first and the last.
std::vector<float> UnevenValues(size_t count, uint32_t seed) {
  UniformNumbers numbers(seed);
  std::vector<float> values(count);
  for (size_t i = 0; i < count; ++i) {
    const float x = numbers.Next();
    values[i] = i % 7 == 0 || i + 1 == count ? 0 : x * x * x * 1000 + 0.01f;
  }
  return values;
}

std::vector<double> Shares(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += value;
  std::vector<double> shares;
  for (const float value : values) shares.push_back(value / sum);
  return shares;
}

// P1
TEST(Distribution1D, FollowsItsDensity) {
  const std::vector<float> values = UnevenValues(200, 1);
  const Distribution1D distribution(values);
  UniformNumbers numbers(2);
  std::vector<uint64_t> counts(values.size());
  for (int i = 0; i < kSamples; ++i) {
    const Distribution1D::Sample sample = distribution.Draw(numbers.Next());
    ASSERT_TRUE(sample.position >= 0 && sample.position < 1);
    ++counts[sample.interval];
  }
  EXPECT_LT(ChiSquareDeviate(counts, Shares(values)), kLargestDeviate);
}

TEST(Distribution1D, DensityIsTheValueOverTheMean) {
  const Distribution1D distribution(std::vector<float>{1, 0, 3, 4});
  EXPECT_FLOAT_EQ(distribution.Pdf(0.1f), 0.5f);
  EXPECT_EQ(distribution.Pdf(0.3f), 0.0f);
  EXPECT_FLOAT_EQ(distribution.Pdf(0.6f), 1.5f);
  EXPECT_FLOAT_EQ(distribution.Pdf(0.9f), 2.0f);
}

// P2, P3
TEST(Distribution1D, SampleAndDensityAgreeAndInvert) {
  const Distribution1D distribution(UnevenValues(100, 3));
  UniformNumbers numbers(4);
  for (int i = 0; i < 100000; ++i) {
    const float u = numbers.Next();
    const Distribution1D::Sample sample = distribution.Draw(u);
    ASSERT_GT(sample.pdf, 0.0f);
    ASSERT_NEAR(distribution.Invert(sample.position), u, 1e-5f);
  }
}

TEST(Distribution1D, OfZerosIsUniform) {
  const Distribution1D distribution(std::vector<float>(8, 0.0f));
  EXPECT_FLOAT_EQ(distribution.Draw(0.3f).position, 0.3f);
  EXPECT_EQ(distribution.Pdf(0.3f), 1.0f);
}

// Where the first and the last interval are empty, the ends of [0, 1) belong to their neighbours.
TEST(Distribution1D, NeverDrawsWhatHasNoShare) {
  const Distribution1D distribution(std::vector<float>{0, 0, 1, 0, 0});
  for (const float u : {0.0f, 0x1p-24f, 0.5f, 0x1.fffffep-1f}) {
    const Distribution1D::Sample sample = distribution.Draw(u);
    EXPECT_EQ(sample.interval, 2u) << u;
    EXPECT_FLOAT_EQ(sample.pdf, 5) << u;
  }
}

// P1
TEST(Distribution2D, FollowsItsDensity) {
  constexpr size_t kColumns = 40;
  const std::vector<float> values = UnevenValues(kColumns * 25, 5);
  const Distribution2D distribution(values, kColumns);
  UniformNumbers numbers(6);
  std::vector<uint64_t> counts(values.size());
  for (int i = 0; i < kSamples; ++i) {
    const Vec2 p = distribution.Draw(numbers.NextPair()).position;
    const auto x = static_cast<size_t>(p.x * kColumns), y = static_cast<size_t>(p.y * 25);
    ++counts[y * kColumns + x];
  }
  // Positions are rounded: of those at the very edge of a cell a few may fall into the next one.
  uint64_t strays = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0) strays += counts[i];
    if (values[i] == 0) counts[i] = 0;
  }
  EXPECT_LT(strays, 20u);
  EXPECT_LT(ChiSquareDeviate(counts, Shares(values)), kLargestDeviate);
}

// P2, P3
TEST(Distribution2D, DensityIntegratesToOneAndInverts) {
  constexpr size_t kColumns = 32, kRows = 16;
  const Distribution2D distribution(UnevenValues(kColumns * kRows, 7), kColumns);
  double integral = 0;
  for (size_t y = 0; y < kRows; ++y) {
    for (size_t x = 0; x < kColumns; ++x) {
      const Vec2 middle{(static_cast<float>(x) + 0.5f) / kColumns,
                        (static_cast<float>(y) + 0.5f) / kRows};
      integral += static_cast<double>(distribution.Pdf(middle)) / (kColumns * kRows);
    }
  }
  EXPECT_NEAR(integral, 1, 1e-6);

  UniformNumbers numbers(8);
  int same = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec2 u = numbers.NextPair();
    const Distribution2D::Sample sample = distribution.Draw(u);
    same += distribution.Pdf(sample.position) == sample.pdf;
    const Vec2 back = distribution.Invert(sample.position);
    ASSERT_NEAR(back.x, u.x, 1e-5f);
    ASSERT_NEAR(back.y, u.y, 1e-5f);
  }
  EXPECT_GT(same, 9990) << "only at the edges of cells may rounding make a difference";
}

}  // namespace
}  // namespace candela
