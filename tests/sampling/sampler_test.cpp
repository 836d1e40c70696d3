#include "sampling/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;

/// Whether each of the 2^m boxes of 2^a columns and 2^(m-a) rows holds exactly one of 2^m points.
bool IsStratified(const std::vector<Vec2>& points, int m, int a) {
  std::vector<int> boxes(points.size());
  for (const Vec2 p : points) {
    const auto column = static_cast<size_t>(std::ldexp(p.x, a));
    const auto row = static_cast<size_t>(std::ldexp(p.y, m - a));
    if (++boxes[(row << a) + column] > 1) return false;
  }
  return true;
}

// The (0,m,2)-net property, for the first 2^m samples and for later aligned runs.
TEST(SobolSampler, RunsOf2ToTheMSamplesAreNets) {
  for (int m = 0; m <= 10; ++m) {
    for (const uint32_t run : {0u, 1u, 5u}) {
      for (uint32_t pixel = 0; pixel < 10; ++pixel) {
        std::vector<Vec2> points;
        for (uint32_t i = 0; i < 1u << m; ++i) {
          points.push_back(Sampler(3, pixel, 7 * pixel, (run << m) + i).Get2D(BounceDimension(1)));
        }
        for (int a = 0; a <= m; ++a) ASSERT_TRUE(IsStratified(points, m, a)) << m << " " << a;
      }
    }
  }
}

TEST(SobolSampler, SingleDimensionsAreStratified) {
  for (uint32_t dimension = 0; dimension < 40; ++dimension) {
    std::vector<int> cells(256);
    for (uint32_t i = 0; i < 256; ++i) {
      ++cells[static_cast<size_t>(Sampler(1, 20, 30, i).Get1D(dimension) * 256)];
    }
    for (const int count : cells) ASSERT_EQ(count, 1) << dimension;
  }
}

TEST(IndependentSampler, IsNotStratified) {
  std::vector<Vec2> points;
  for (uint32_t i = 0; i < 256; ++i) {
    points.push_back(Sampler(1, 0, 0, i, SamplerKind::kIndependent).Get2D(0));
  }
  EXPECT_FALSE(IsStratified(points, 8, 4));
}

class EverySampler : public testing::TestWithParam<SamplerKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EverySampler,
                         testing::Values(SamplerKind::kSobol, SamplerKind::kIndependent));

TEST_P(EverySampler, NumbersLieInTheHalfOpenUnitInterval) {
  float largest = 0;
  for (uint32_t i = 0; i < 2000000; ++i) {
    const Sampler sampler(0, 0, 0, i * 2147u, GetParam());
    const float x = sampler.Get1D(i & 31);
    ASSERT_TRUE(x >= 0 && x < 1);
    largest = std::max(largest, x);
  }
  EXPECT_GT(largest, 0.99999f);
}

TEST_P(EverySampler, IsAFunctionOfItsArguments) {
  const Sampler a(1, 2, 3, 4, GetParam());
  const Vec2 first = a.Get2D(16);
  a.Get1D(5);
  EXPECT_EQ(a.Get2D(16), first);
  EXPECT_EQ(Sampler(1, 2, 3, 4, GetParam()).Get2D(16), first);
  EXPECT_FALSE(Sampler(0, 2, 3, 4, GetParam()).Get2D(16) == first);
  EXPECT_FALSE(Sampler(1, 3, 2, 4, GetParam()).Get2D(16) == first);
  EXPECT_FALSE(Sampler(1, 2, 3, 5, GetParam()).Get2D(16) == first);
  EXPECT_FALSE(a.Get2D(18) == first);
}

/// A way to walk through samples that has to give independent uniform pairs.
struct Walk {
  const char* name;
  std::function<Vec2(uint32_t i, SamplerKind)> pair;
};

// Within a pixel the points are more even than chance. Across pixels, seeds and dimensions they
// must look like dice: a repeated or related scrambling shows as a picture-wide pattern.
const Walk kWalks[] = {
    {"pair of the first sample over pixels",
     [](uint32_t i, SamplerKind kind) { return Sampler(0, i % 1000, i / 1000, 0, kind).Get2D(0); }},
    {"neighbouring pixels",
     [](uint32_t i, SamplerKind kind) {
       const uint32_t x = i % 1000, y = i / 1000;
       return Vec2{Sampler(0, x, y, 3, kind).Get1D(2), Sampler(0, x + 1, y, 3, kind).Get1D(2)};
     }},
    {"pixels above each other",
     [](uint32_t i, SamplerKind kind) {
       const uint32_t x = i % 1000, y = i / 1000;
       return Vec2{Sampler(0, x, y, 3, kind).Get1D(2), Sampler(0, x, y + 1, 3, kind).Get1D(2)};
     }},
    {"neighbouring dimensions over pixels",
     [](uint32_t i, SamplerKind kind) {
       const Sampler sampler(0, i % 1000, i / 1000, 1, kind);
       return Vec2{sampler.Get1D(16), sampler.Get1D(17)};
     }},
    {"neighbouring dimensions over samples",
     [](uint32_t i, SamplerKind kind) {
       const Sampler sampler(0, i % 4001, 0, i / 4001, kind);
       return Vec2{sampler.Get1D(16), sampler.Get1D(17)};
     }},
    {"same dimension of two bounces",
     [](uint32_t i, SamplerKind kind) {
       const Sampler sampler(0, i % 4001, 5, i / 4001, kind);
       return Vec2{sampler.Get2D(BounceDimension(0)).y, sampler.Get2D(BounceDimension(1)).y};
     }},
    {"seeds",
     [](uint32_t i, SamplerKind kind) {
       return Vec2{Sampler(i, 9, 9, 0, kind).Get1D(0), Sampler(i + 1, 9, 9, 0, kind).Get1D(0)};
     }},
};

// P1
TEST_P(EverySampler, PairsAreUniformAndIndependentAcrossPixelsAndDimensions) {
  constexpr uint32_t kSamples = 1000000;
  constexpr size_t kSide = 32;
  for (const Walk& walk : kWalks) {
    std::vector<uint64_t> counts(kSide * kSide);
    double covariance = 0;
    for (uint32_t i = 0; i < kSamples; ++i) {
      const Vec2 p = walk.pair(i, GetParam());
      ++counts[static_cast<size_t>(p.y * kSide) * kSide + static_cast<size_t>(p.x * kSide)];
      covariance += (static_cast<double>(p.x) - 0.5) * (static_cast<double>(p.y) - 0.5);
    }
    const std::vector<double> shares(kSide * kSide, 1.0 / (kSide * kSide));
    EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate) << walk.name;
    EXPECT_LT(std::abs(covariance * 12 / std::sqrt(kSamples)), kLargestDeviate) << walk.name;
  }
}

// Recorded once: other numbers mean other noise in every stored picture.
TEST(SobolSampler, NumbersAreTheSameEverywhere) {
  EXPECT_EQ(Sampler(1, 20, 30, 0).Get1D(0), 0x1.82e842p-1f);
  EXPECT_EQ(Sampler(1, 20, 30, 0).Get2D(16), (Vec2{0x1.35f6eap-1f, 0x1.539a94p-1f}));
  EXPECT_EQ(Sampler(1, 20, 30, 77777).Get2D(16), (Vec2{0x1.7e02a8p-3f, 0x1.430a24p-1f}));
}

// What the scrambling buys: the error of a smooth integral falls with N^-1.5 instead of N^-0.5.
TEST(SobolSampler, IntegratesASmoothFunctionFarBetterThanDice) {
  const auto error = [](SamplerKind kind) {
    double sum_of_squares = 0;
    for (uint32_t pixel = 0; pixel < 200; ++pixel) {
      double sum = 0;
      for (uint32_t i = 0; i < 256; ++i) {
        const Vec2 u = Sampler(0, pixel, 0, i, kind).Get2D(0);
        sum += static_cast<double>(u.x * u.x * u.y);
      }
      sum_of_squares += (sum / 256 - 1.0 / 6) * (sum / 256 - 1.0 / 6);
    }
    return std::sqrt(sum_of_squares / 200);
  };
  EXPECT_NEAR(error(SamplerKind::kIndependent), 0.0122, 0.0025);  // standard deviation / 16
  EXPECT_LT(error(SamplerKind::kSobol), 0.0122 / 25);
}

}  // namespace
}  // namespace candela
