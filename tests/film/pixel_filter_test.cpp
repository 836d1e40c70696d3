#include "film/pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "math/elementary.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

class EveryFilter : public testing::TestWithParam<PixelFilterEntry> {
 protected:
  const PixelFilterEntry& entry_ = GetParam();
  const PixelFilter filter_{GetParam()};

  /// The integral of g(x) times the profile over [from, to], by the midpoint rule.
  template <class Function>
  double Integral(double from, double to, Function g) const {
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = from + (to - from) * (i + 0.5) / kSteps;
      sum += g(x) * entry_.profile(std::abs(x));
    }
    return sum * (to - from) / kSteps;
  }

  /// The mean of g(x offset) times weight over evenly spread samples.
  template <class Function>
  double Mean(Function g) const {
    constexpr uint32_t kSteps = 1 << 20;
    double sum = 0;
    for (uint32_t i = 0; i < kSteps; ++i) {
      // In y all weights have to count, or those of negative filters do not average to 1.
      const uint32_t j = i * 648055 % kSteps;  // Both make a lattice of the golden ratio.
      const FilterSample sample = filter_.Sample({Middle(i, kSteps), Middle(j, kSteps)});
      sum += static_cast<double>(sample.weight) * g(static_cast<double>(sample.offset.x));
    }
    return sum / kSteps;
  }

  static float Middle(uint32_t i, uint32_t count) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
  }
};

INSTANTIATE_TEST_SUITE_P(Table, EveryFilter,
                         testing::ValuesIn(PixelFilters().begin(), PixelFilters().end()),
                         [](const auto& row) { return std::string(row.param.name); });

// P15
TEST_P(EveryFilter, ExpectedWeightIsOne) {
  EXPECT_NEAR(Mean([](double) { return 1.0; }), 1, 1e-4);
}

// P15: the centroid: a filter that is off centre moves the picture.
TEST_P(EveryFilter, IsCentred) {
  EXPECT_NEAR(Mean([](double x) { return x; }), 0, 1e-4);
  const FilterSample middle = filter_.Sample({0.5f, 0.5f});
  EXPECT_NEAR(middle.offset.x, 0, 1e-6);
  EXPECT_NEAR(middle.offset.y, 0, 1e-6);
}

// The response to a wave, from the samples, is the one of the profile itself.
TEST_P(EveryFilter, TransfersWavesAsItsProfileDoes) {
  for (const double frequency : {0.1, 0.25, 0.5, 1.0}) {
    const auto wave = [&](double x) { return std::cos(2 * kPi * frequency * x); };
    const double r = static_cast<double>(entry_.radius);
    const double expected = Integral(-r, r, wave) / Integral(-r, r, [](double) { return 1.0; });
    EXPECT_NEAR(Mean(wave), expected, 1e-4) << frequency;
  }
}

// As the density of an infinite picture: what splats are weighed with is what samples are drawn by.
TEST_P(EveryFilter, ValuesAreThoseOfTheProfile) {
  const double r = static_cast<double>(entry_.radius);
  const double integral = Integral(-r, r, [](double) { return 1.0; });
  EXPECT_EQ(filter_.At({entry_.radius * 1.001f, 0}), 0.0f);
  EXPECT_EQ(filter_.At({0, -entry_.radius * 1.001f}), 0.0f);
  for (int i = 0; i < 400; ++i) {
    const Vec2 offset{entry_.radius * (static_cast<float>(i) / 200 - 1),
                      entry_.radius * (static_cast<float>(i % 37) / 40)};
    const double expected = entry_.profile(static_cast<double>(std::abs(offset.x))) *
                            entry_.profile(static_cast<double>(std::abs(offset.y))) /
                            (integral * integral);
    EXPECT_NEAR(filter_.At(offset), expected, 2e-4) << offset.x << ' ' << offset.y;
  }
}

// P1
TEST_P(EveryFilter, PositionsFollowTheMagnitudeOfTheProfile) {
  constexpr size_t kSide = 32;
  const double r = static_cast<double>(entry_.radius);
  std::vector<double> axis;
  double total = 0;
  for (size_t i = 0; i < kSide; ++i) {
    const double from = -r + 2 * r * static_cast<double>(i) / kSide;
    const auto sign = [&](double x) { return entry_.profile(std::abs(x)) < 0 ? -1.0 : 1.0; };
    axis.push_back(Integral(from, from + 2 * r / kSide, sign));
    total += axis.back();
  }
  std::vector<double> shares;
  for (const double y : axis) {
    for (const double x : axis) shares.push_back(x * y / (total * total));
  }

  UniformNumbers numbers(4);
  std::vector<uint64_t> counts(kSide * kSide);
  for (int i = 0; i < 1000000; ++i) {
    const FilterSample sample = filter_.Sample(numbers.NextPair());
    ASSERT_LE(std::abs(sample.offset.x), entry_.radius);
    ASSERT_LE(std::abs(sample.offset.y), entry_.radius);
    const auto cell = [&](float offset) {
      return std::min(static_cast<size_t>((static_cast<double>(offset) / r + 1) / 2 * kSide),
                      kSide - 1);
    };
    ++counts[cell(sample.offset.y) * kSide + cell(sample.offset.x)];
  }
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
}

TEST_P(EveryFilter, WeightHasTheSignOfTheFilterAndOneMagnitude) {
  UniformNumbers numbers(5);
  const float magnitude = std::abs(filter_.Sample({0.5f, 0.5f}).weight);
  const auto value = [&](float x) { return entry_.profile(std::abs(static_cast<double>(x))); };
  for (int i = 0; i < 100000; ++i) {
    const FilterSample sample = filter_.Sample(numbers.NextPair());
    ASSERT_EQ(std::abs(sample.weight), magnitude);
    const double height = value(sample.offset.x) * value(sample.offset.y);
    if (std::abs(height) > 0.05) {  // One cell around a zero takes the sign of its middle.
      ASSERT_EQ(sample.weight < 0, height < 0);
    }
  }
}

double TransferAtQuarter(std::string_view name) {
  const PixelFilter filter(*FindPixelFilter(name));
  constexpr int kSteps = 1 << 16;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const FilterSample sample = filter.Sample({static_cast<float>(i + 0.5) / kSteps, 0.5f});
    sum += std::cos(kPi / 2 * static_cast<double>(sample.offset.x));
  }
  return sum / kSteps;
}

// P15, CF26: Closed forms at 0.25 cycles per pixel: sinc, sinc squared, and the endless Gaussian,
// which the cut at three deviations misses by 0.5 percent.
TEST(PixelFilter, TransferMatchesTheClosedForms) {
  EXPECT_NEAR(TransferAtQuarter("box"), 0.900316, 1e-6);
  EXPECT_NEAR(TransferAtQuarter("tent"), 0.810569, 1e-6);
  EXPECT_NEAR(TransferAtQuarter("gaussian"), 0.734603, 0.01 * 0.734603);
}

TEST(PixelFilter, PositiveFiltersHaveWeightOne) {
  for (const char* name : {"box", "tent", "gaussian"}) {
    EXPECT_EQ(PixelFilter(*FindPixelFilter(name)).Sample({0.1f, 0.9f}).weight, 1) << name;
  }
}

TEST(PixelFilter, BoxIsTheUnitSquare) {
  const PixelFilter box(*FindPixelFilter("box"));
  EXPECT_EQ(box.Sample({0, 0.75f}).offset, (Vec2{-0.5f, 0.25f}));
  EXPECT_EQ(box.Sample({0x1.fffffep-1f, 0.5f}).offset, (Vec2{0x1.fffffcp-2f, 0}));
}

TEST(PixelFilter, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const PixelFilterEntry& entry : PixelFilters()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(FindPixelFilter(entry.name), &entry);
    EXPECT_FALSE(entry.description.empty());
  }
  EXPECT_EQ(FindPixelFilter("gauss"), nullptr);
}

}  // namespace
}  // namespace candela
