#include "sampling/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/isa.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/forced_isa.h"

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

// Blocks of 16: one sample in each square, column and row.
TEST(StratifiedSampler, BlocksFillEveryStratum) {
  for (const uint32_t block : {0u, 1u, 6u}) {
    for (uint32_t pixel = 0; pixel < 50; ++pixel) {
      std::vector<Vec2> points;
      std::vector<int> cells(16);
      for (uint32_t i = 0; i < 16; ++i) {
        const Sampler sampler(3, pixel, 2, 16 * block + i, SamplerKind::kStratified);
        points.push_back(sampler.Get2D(BounceDimension(1)));
        ++cells[static_cast<size_t>(sampler.Get1D(kFilmDimension) * 16)];
      }
      for (const int a : {0, 2, 4}) ASSERT_TRUE(IsStratified(points, 4, a)) << pixel << " " << a;
      for (const int count : cells) ASSERT_EQ(count, 1) << pixel;
    }
  }
}

TEST(StratifiedSampler, OrderOfStrataDiffersFromPixelToPixel) {
  std::vector<int> cells(16);
  for (uint32_t pixel = 0; pixel < 1600; ++pixel) {
    const Sampler sampler(0, pixel, 0, 0, SamplerKind::kStratified);
    ++cells[static_cast<size_t>(sampler.Get1D(5) * 16)];
  }
  for (const int count : cells) EXPECT_NEAR(count, 100, 50);
}

// Many at once are drawn in blocks, by the code of each instruction set; the last block may be any
// part of one.
TEST(EverySampler, GivesTheSameNumbersAloneAndTogether) {
  for (const SamplerEntry& entry : Samplers()) {
    std::vector<Sampler> samplers;
    for (uint32_t i = 0; i < 200; ++i) {
      samplers.push_back(Sampler(7, 31 * i, i / 3, i * i, {entry.kind, 16}));
    }
    for (const Isa isa : {Isa::kScalar, Isa::kAvx2, Isa::kAvx512}) {
      if (!IsSupported(isa)) continue;
      const test::ForcedIsa forced(isa);
      for (const size_t count : {0, 1, 63, 64, 65, 200}) {
        const std::span<const Sampler> some = std::span(samplers).first(count);
        std::vector<float> numbers(count);
        std::vector<Vec2> pairs(count);
        for (const uint32_t dimension : {0u, 3u, BounceDimension(9) + 4}) {
          Sampler::Get1D(some, dimension, numbers);
          Sampler::Get2D(some, dimension, pairs);
          for (size_t i = 0; i < count; ++i) {
            ASSERT_EQ(numbers[i], some[i].Get1D(dimension)) << entry.name << IsaName(isa) << i;
            ASSERT_EQ(pairs[i], some[i].Get2D(dimension)) << entry.name << IsaName(isa) << i;
          }
        }
      }
    }
  }
}

SamplerType BlueNoise(uint32_t samples) {
  return {SamplerKind::kBlueNoise, samples};
}

// The samples of a pixel are a net, and so are those of 2 x 2 and of 8 x 8 pixels together.
TEST(BlueNoiseSampler, SquaresOfPixelsAreNetsTogether) {
  for (const auto& [side, m] : {std::pair(1u, 2), std::pair(2u, 4), std::pair(8u, 8)}) {
    for (const uint32_t corner : {0u, 8u, 8u * 31}) {
      for (const uint32_t first : {0u, 4u}) {  // Also beyond the number it was made for.
        std::vector<Vec2> points;
        for (uint32_t pixel = 0; pixel < side * side; ++pixel) {
          for (uint32_t i = 0; i < 4; ++i) {
            const Sampler sampler(1, corner + pixel % side, 16 + pixel / side, first + i,
                                  BlueNoise(4));
            points.push_back(sampler.Get2D(BounceDimension(0)));
          }
        }
        for (int a = 0; a <= m; ++a) ASSERT_TRUE(IsStratified(points, m, a)) << side << " " << a;
      }
    }
  }
}

TEST(BlueNoiseSampler, IsMadeForAPowerOfTwo) {
  EXPECT_EQ(BlueNoise(1).log2_samples, 0);
  EXPECT_EQ(BlueNoise(64).log2_samples, 6);
  EXPECT_EQ(BlueNoise(65).log2_samples, 7);
  EXPECT_EQ(BlueNoise(4000000000u).log2_samples, 16);
  EXPECT_EQ(SamplerType(SamplerKind::kSobol, 64).log2_samples, 0);
}

// What it is for: the errors of neighbours cancel, so that a blurred picture is nearly clean.
TEST(BlueNoiseSampler, NoiseHasLittleOfLowFrequency) {
  constexpr uint32_t kSide = 64, kBlock = 8, kSamples = 4;
  struct Noise {
    double of_pixels = 0, of_blocks = 0;  ///< Mean squares of the error.
  };
  const auto noise_of = [&](SamplerType type) {
    Noise noise;
    std::vector<double> blocks((kSide / kBlock) * (kSide / kBlock));
    for (uint32_t y = 0; y < kSide; ++y) {
      for (uint32_t x = 0; x < kSide; ++x) {
        double mean = 0;
        for (uint32_t i = 0; i < kSamples; ++i) {
          const Vec2 u = Sampler(5, x, y, i, type).Get2D(BounceDimension(0));
          // A disk, like the edge of a shadow: no polynomial that a net would integrate exactly.
          const float dx = u.x - 0.4f, dy = u.y - 0.3f;
          mean += dx * dx + dy * dy < 0.09f ? 1.0 / kSamples : 0;
        }
        const double error = mean - 0.28274334;  // pi 0.3^2
        noise.of_pixels += error * error / (kSide * kSide);
        blocks[y / kBlock * (kSide / kBlock) + x / kBlock] += error / (kBlock * kBlock);
      }
    }
    for (const double error : blocks) {
      noise.of_blocks += error * error / static_cast<double>(blocks.size());
    }
    return noise;
  };
  const Noise sobol = noise_of(SamplerKind::kSobol), blue = noise_of(BlueNoise(kSamples));
  EXPECT_NEAR(sobol.of_blocks * kBlock * kBlock / sobol.of_pixels, 1, 0.5);  // White.
  EXPECT_LT(blue.of_blocks, sobol.of_blocks / 5);
  EXPECT_LT(blue.of_pixels, sobol.of_pixels * 1.5);
}

TEST(Samplers, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const SamplerEntry& entry : Samplers()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(FindSampler(entry.name), &entry);
    EXPECT_FALSE(entry.description.empty());
  }
  EXPECT_EQ(FindSampler("sobel"), nullptr);
}

class EverySampler : public testing::TestWithParam<SamplerEntry> {
 protected:
  /// Where it matters, made for 16 samples.
  SamplerType Type() const { return {GetParam().kind, 16}; }
};
INSTANTIATE_TEST_SUITE_P(Registry, EverySampler,
                         testing::ValuesIn(Samplers().begin(), Samplers().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(EverySampler, NumbersLieInTheHalfOpenUnitInterval) {
  float largest = 0;
  for (uint32_t i = 0; i < 2000000; ++i) {
    const Sampler sampler(0, 0, 0, i * 2147u, Type());
    const float x = sampler.Get1D(i & 31);
    ASSERT_TRUE(x >= 0 && x < 1);
    largest = std::max(largest, x);
  }
  EXPECT_GT(largest, 0.99999f);
}

TEST_P(EverySampler, IsAFunctionOfItsArguments) {
  const Sampler a(1, 2, 3, 4, Type());
  const Vec2 first = a.Get2D(16);
  a.Get1D(5);
  EXPECT_EQ(a.Get2D(16), first);
  EXPECT_EQ(Sampler(1, 2, 3, 4, Type()).Get2D(16), first);
  EXPECT_FALSE(Sampler(0, 2, 3, 4, Type()).Get2D(16) == first);
  EXPECT_FALSE(Sampler(1, 3, 2, 4, Type()).Get2D(16) == first);
  EXPECT_FALSE(Sampler(1, 2, 3, 5, Type()).Get2D(16) == first);
  EXPECT_FALSE(a.Get2D(18) == first);
}

/// A way to walk through samples that has to give independent uniform pairs.
struct Walk {
  const char* name;
  bool compares_pixels;  ///< Not for samplers whose pixels know of each other.
  std::function<Vec2(uint32_t i, SamplerType)> pair;
};

// Within a pixel the points are more even than chance. Across pixels, seeds and dimensions they
// must look like dice: a repeated or related scrambling shows as a picture-wide pattern.
const Walk kWalks[] = {
    {"pair of the first sample over pixels", false,
     [](uint32_t i, SamplerType type) { return Sampler(0, i % 1000, i / 1000, 0, type).Get2D(0); }},
    {"neighbouring pixels", true,
     [](uint32_t i, SamplerType type) {
       const uint32_t x = i % 1000, y = i / 1000;
       return Vec2{Sampler(0, x, y, 3, type).Get1D(2), Sampler(0, x + 1, y, 3, type).Get1D(2)};
     }},
    {"pixels above each other", true,
     [](uint32_t i, SamplerType type) {
       const uint32_t x = i % 1000, y = i / 1000;
       return Vec2{Sampler(0, x, y, 3, type).Get1D(2), Sampler(0, x, y + 1, 3, type).Get1D(2)};
     }},
    {"neighbouring dimensions over pixels", false,
     [](uint32_t i, SamplerType type) {
       const Sampler sampler(0, i % 1000, i / 1000, 1, type);
       return Vec2{sampler.Get1D(16), sampler.Get1D(17)};
     }},
    {"neighbouring dimensions over samples", false,
     [](uint32_t i, SamplerType type) {
       const Sampler sampler(0, i % 4001, 0, i / 4001, type);
       return Vec2{sampler.Get1D(16), sampler.Get1D(17)};
     }},
    {"same dimension of two bounces", false,
     [](uint32_t i, SamplerType type) {
       const Sampler sampler(0, i % 4001, 5, i / 4001, type);
       return Vec2{sampler.Get2D(BounceDimension(0)).y, sampler.Get2D(BounceDimension(1)).y};
     }},
    {"seeds", false,
     [](uint32_t i, SamplerType type) {
       return Vec2{Sampler(i, 9, 9, 0, type).Get1D(0), Sampler(i + 1, 9, 9, 0, type).Get1D(0)};
     }},
};

// P1
TEST_P(EverySampler, PairsAreUniformAndIndependentAcrossPixelsAndDimensions) {
  constexpr uint32_t kSamples = 1000000;
  constexpr size_t kSide = 32;
  for (const Walk& walk : kWalks) {
    if (walk.compares_pixels && !GetParam().has_independent_pixels) continue;
    std::vector<uint64_t> counts(kSide * kSide);
    double covariance = 0;
    for (uint32_t i = 0; i < kSamples; ++i) {
      const Vec2 p = walk.pair(i, Type());
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
