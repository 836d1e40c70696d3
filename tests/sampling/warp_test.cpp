#include "sampling/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/sampling/chi_square.h"
#include "tests/support/forced_isa.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

constexpr int kSamples = 1000000;
constexpr size_t kRings = 24;
constexpr size_t kSectors = 40;

/// A warp to directions, and the share of samples above the height z in closed form.
struct DirectionWarp {
  const char* name;
  Vec3 (*sample)(Vec2);
  Vec2 (*invert)(Vec3);
  float (*pdf)(Vec3);
  double (*share_above)(double z);
  double lowest;
};

constexpr DirectionWarp kWarps[] = {
    {"CosineHemisphere", SampleCosineHemisphere, InvertCosineHemisphere,
     [](Vec3 w) { return CosineHemispherePdf(w.z); }, [](double z) { return 1 - z * z; }, 0},
    {"UniformHemisphere", SampleUniformHemisphere, InvertUniformHemisphere,
     [](Vec3) { return UniformHemispherePdf(); }, [](double z) { return 1 - z; }, 0},
    {"UniformSphere", SampleUniformSphere, InvertUniformSphere,
     [](Vec3) { return UniformSpherePdf(); }, [](double z) { return (1 - z) / 2; }, -1},
};

class Directions : public testing::TestWithParam<DirectionWarp> {};
INSTANTIATE_TEST_SUITE_P(Warps, Directions, testing::ValuesIn(kWarps),
                         [](const auto& warp) { return std::string(warp.param.name); });

size_t SectorOf(float x, float y) {
  const double turn = std::atan2(y, x) / (2 * kPi) + 0.5;
  return std::min(static_cast<size_t>(turn * kSectors), kSectors - 1);
}

// P1: cells are rings of equal height times sectors; their shares are known without quadrature.
TEST_P(Directions, FollowTheirDensity) {
  const DirectionWarp& warp = GetParam();
  UniformNumbers numbers(1);
  std::vector<uint64_t> counts(kRings * kSectors);
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 w = warp.sample(numbers.NextPair());
    const double height = (static_cast<double>(w.z) - warp.lowest) / (1 - warp.lowest);
    const size_t ring = std::min(static_cast<size_t>(height * kRings), kRings - 1);
    ++counts[ring * kSectors + SectorOf(w.x, w.y)];
  }
  std::vector<double> shares;
  const double step = (1 - warp.lowest) / kRings;
  for (size_t cell = 0; cell < counts.size(); ++cell) {
    const double z = warp.lowest + step * static_cast<double>(cell / kSectors);
    shares.push_back((warp.share_above(z) - warp.share_above(z + step)) / kSectors);
  }
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate) << warp.name;
}

// P2: the density is minus the derivative of the share over height, spread over a full turn.
TEST_P(Directions, DensityIsTheDerivativeOfTheShare) {
  const DirectionWarp& warp = GetParam();
  for (int i = 1; i < 100; ++i) {
    const double z = warp.lowest + (1 - warp.lowest) * i / 100;
    const double slope = (warp.share_above(z - 1e-6) - warp.share_above(z + 1e-6)) / 2e-6;
    const auto height = static_cast<float>(z);
    EXPECT_NEAR(warp.pdf({std::sqrt(1 - height * height), 0, height}), slope / (2 * kPi), 1e-6);
  }
  EXPECT_EQ(CosineHemispherePdf(-0.5f), 0);
}

// P3
TEST_P(Directions, AreUnitVectorsAndInvert) {
  const DirectionWarp& warp = GetParam();
  UniformNumbers numbers(2);
  for (int i = 0; i < 100000; ++i) {
    const Vec2 u = numbers.NextPair();
    const Vec3 w = warp.sample(u);
    ASSERT_NEAR(Length(w), 1, 3e-7f);
    ASSERT_GE(w.z, warp.lowest);
    const Vec2 back = warp.invert(w);
    ASSERT_NEAR(back.x, u.x, 1e-5f) << w.x << " " << w.y << " " << w.z;
    // Where the azimuth starts, 0 and 1 are neighbours.
    const float turn = std::abs(back.y - u.y);
    ASSERT_LT(std::min(turn, 1 - turn), 1e-5f) << w.x << " " << w.y << " " << w.z;
    ASSERT_TRUE(back.x >= 0 && back.x <= 1 && back.y >= 0 && back.y <= 1);
  }
}

TEST_P(Directions, CornersOfTheSquareAreSafe) {
  for (const float x : {0.0f, 0.5f, 0x1.fffffep-1f}) {
    for (const float y : {0.0f, 0.5f, 0x1.fffffep-1f}) {
      const Vec3 w = GetParam().sample({x, y});
      EXPECT_NEAR(Length(w), 1, 3e-7f);
      EXPECT_GE(w.z, GetParam().lowest);
    }
  }
}

// Many at once are drawn in blocks, by the code of each instruction set.
TEST(CosineHemisphere, IsTheSameAloneAndTogether) {
  UniformNumbers numbers(9);
  std::vector<Vec2> pairs = {{0.5f, 0.5f}, {0, 0}, {0, 0.5f}, {0.5f, 0x1.fffffep-1f}};
  while (pairs.size() < 200) pairs.push_back(numbers.NextPair());
  for (const Isa isa : {Isa::kScalar, Isa::kAvx2, Isa::kAvx512}) {
    if (!IsSupported(isa)) continue;
    const test::ForcedIsa forced(isa);
    for (const size_t count : {0, 1, 64, 65, 200}) {
      std::vector<Vec3> directions(count);
      SampleCosineHemisphere(std::span(pairs).first(count), directions);
      for (size_t i = 0; i < count; ++i) {
        ASSERT_EQ(directions[i], SampleCosineHemisphere(pairs[i])) << IsaName(isa) << " " << i;
      }
    }
  }
}

// P1, P3
TEST(Disk, FollowsItsDensityAndInverts) {
  UniformNumbers numbers(3);
  std::vector<uint64_t> counts(kRings * kSectors);
  for (int i = 0; i < kSamples; ++i) {
    const Vec2 u = numbers.NextPair();
    const Vec2 p = SampleDisk(u);
    const float area = p.x * p.x + p.y * p.y;
    ASSERT_LE(area, 1.0000002f);
    const size_t ring = std::min(static_cast<size_t>(area * kRings), kRings - 1);
    ++counts[ring * kSectors + SectorOf(p.x, p.y)];
    const Vec2 back = InvertDisk(p);
    ASSERT_NEAR(back.x, u.x, 1e-6f);
    ASSERT_NEAR(back.y, u.y, 1e-6f);
  }
  const std::vector<double> shares(counts.size(), 1.0 / static_cast<double>(counts.size()));
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
  EXPECT_FLOAT_EQ(DiskPdf() * static_cast<float>(kPi), 1);
}

TEST(Disk, MapsCentreToCentreAndCornersToTheRim) {
  EXPECT_EQ(SampleDisk({0.5f, 0.5f}), (Vec2{0, 0}));
  EXPECT_EQ(InvertDisk({0, 0}), (Vec2{0.5f, 0.5f}));
  EXPECT_EQ(SampleDisk({0, 0.5f}), (Vec2{-1, 0}));
  EXPECT_EQ(SampleDisk({0.5f, 0}), (Vec2{0, -1}));
  const Vec2 corner = SampleDisk({0, 0});
  EXPECT_NEAR(corner.x, -std::sqrt(0.5f), 1e-7f);
  EXPECT_NEAR(corner.y, -std::sqrt(0.5f), 1e-7f);
}

// P1, P3: from a sun of half a degree to nearly everything.
TEST(Cone, FollowsItsDensityAndInverts) {
  for (const float one_minus_cosine : {1e-5f, 0.01f, 0.5f, 1.0f, 1.9f}) {
    UniformNumbers numbers(4);
    std::vector<uint64_t> counts(kRings * kSectors);
    for (int i = 0; i < kSamples / 4; ++i) {
      const Vec2 u = numbers.NextPair();
      const Vec3 w = SampleCone(u, one_minus_cosine);
      ASSERT_NEAR(Length(w), 1, 3e-7f);
      const Vec2 back = InvertCone(w, one_minus_cosine);
      ASSERT_NEAR(back.x, u.x, 1e-5f);
      const float turn = std::abs(back.y - u.y);
      ASSERT_LT(std::min(turn, 1 - turn), 1e-5f);
      // The height over the rim, from the distance to the axis.
      const double radius2 = double{w.x} * w.x + double{w.y} * w.y;
      const double below = w.z > 0 ? radius2 / (1 + std::sqrt(std::max(0.0, 1 - radius2)))
                                   : 1 + std::sqrt(std::max(0.0, 1 - radius2));
      const size_t ring =
          std::min(static_cast<size_t>(below / one_minus_cosine * kRings), kRings - 1);
      ++counts[ring * kSectors + SectorOf(w.x, w.y)];
    }
    const std::vector<double> shares(counts.size(), 1.0 / static_cast<double>(counts.size()));
    EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate) << one_minus_cosine;
    EXPECT_FLOAT_EQ(ConePdf(one_minus_cosine) * static_cast<float>(2 * kPi) * one_minus_cosine, 1);
  }
}

// P1, P3: cells of equal area: squares of a grid in the barycentric weights, those across the long
// side cut in half.
TEST(TriangleByArea, FollowsItsDensityAndInverts) {
  constexpr size_t kSide = 20;
  UniformNumbers numbers(5);
  std::vector<uint64_t> counts(kSide * kSide);
  for (int i = 0; i < kSamples; ++i) {
    const Vec2 u = numbers.NextPair();
    const Vec2 b = SampleTriangle(u);
    ASSERT_TRUE(b.x >= 0 && b.y >= 0 && b.x + b.y <= 1);
    const Vec2 back = InvertTriangle(b);
    ASSERT_NEAR(back.x, u.x, 1e-6f);
    ASSERT_NEAR(back.y, u.y, 1e-6f);
    const auto x = std::min(static_cast<size_t>(b.x * kSide), kSide - 1);
    const auto y = std::min(static_cast<size_t>(b.y * kSide), kSide - 1);
    ++counts[y * kSide + x];
  }
  std::vector<double> shares(counts.size());
  for (size_t y = 0; y < kSide; ++y) {
    for (size_t x = 0; x < kSide; ++x) {
      const double whole = 2.0 / (kSide * kSide);
      shares[y * kSide + x] = x + y + 1 < kSide ? whole : x + y + 1 == kSide ? whole / 2 : 0;
    }
  }
  // On the very diagonal rounding may put a sample into the next square.
  for (size_t i = 1; i < kSide; ++i) EXPECT_LT(counts[i * kSide + kSide - i], 5u);
  for (size_t i = 1; i < kSide; ++i) counts[i * kSide + kSide - i] = 0;
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
}

}  // namespace
}  // namespace candela
