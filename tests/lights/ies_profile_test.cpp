#include "lights/ies_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/elementary.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

/// In the frame of a profile, where z is down.
Vec3 DirectionAt(double vertical, double horizontal) {
  return ToFloat(Vec3d{SinDegrees(vertical) * CosDegrees(horizontal),
                       SinDegrees(vertical) * SinDegrees(horizontal), CosDegrees(vertical)});
}

/// Of 10 candela everywhere.
IesProfile Even() {
  return IesProfile({{0, 180}, {0, 360}, {10, 10, 10, 10}});
}

/// With all kinds of cells: from 20 degrees on, uneven steps, dark ones.
IesProfile Uneven() {
  return IesProfile({{20, 45, 50, 90, 135},
                     {0, 30, 120, 300, 360},
                     {1, 5, 9, 2, 0, 3, 0, 0, 2, 8, 0, 0, 4, 4, 0, 7, 2, 1, 0, 0, 1, 5, 9, 2, 0},
                     50});
}

TEST(IesProfile, IsLinearInBothAngles) {
  // Columns at 0, 90 and 360 degrees; rows at 0 and 80.
  const IesProfile profile({{0, 80}, {0, 90, 360}, {4, 12, 4, 28, 4, 12}});
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(40, 0)), 8);
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(10, 0)), 5);
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(40, 45)), 12);
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(10, 45)), 6);
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(20, 225)), 8);
  EXPECT_FLOAT_EQ(profile.Intensity({0, 0, 1}), 4);
}

TEST(IesProfile, IsDarkBeyondItsVerticalAngles) {
  EXPECT_EQ(Uneven().Intensity(DirectionAt(19.9, 10)), 0);
  EXPECT_EQ(Uneven().Intensity(DirectionAt(135.1, 10)), 0);
  EXPECT_GT(Uneven().Intensity(DirectionAt(20.1, 10)), 0);
  EXPECT_EQ(Uneven().Pdf(DirectionAt(19.9, 10)), 0);
}

TEST(IesProfile, BeginsAtItsFirstHorizontalAngle) {
  const IesProfile profile({{0, 180}, {0, 180, 360}, {1, 1, 3, 3, 1, 1}, 90});
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(60, 90)), 1);
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(60, -90)), 3);
  EXPECT_FLOAT_EQ(profile.Intensity(DirectionAt(60, 0)), 2);
}

// 4 pi I of an even lamp; pi I of one with the cosine.
TEST(IesProfile, HasTheFluxOfLampsInClosedForm) {
  EXPECT_NEAR(Even().Flux(), 40 * kPi, 1e-5);
  IesProfile::Table cosine{{}, {0, 360}, {}};
  for (int degrees = 0; degrees <= 90; ++degrees) {
    cosine.vertical.push_back(static_cast<float>(degrees));
    cosine.candela.push_back(static_cast<float>(100 * CosDegrees(degrees)));
  }
  const std::vector<float> column = cosine.candela;
  cosine.candela.insert(cosine.candela.end(), column.begin(), column.end());
  EXPECT_NEAR(IesProfile(cosine).Flux() / (100 * kPi), 1, 5e-5);
}

// The sum in closed form over the cells of the table against the midpoints of a fine grid.
TEST(IesProfile, HasTheFluxOfItsIntegral) {
  constexpr int kRows = 1440, kColumns = 720;
  const IesProfile profile = Uneven();
  double sum = 0;
  for (int row = 0; row < kRows; ++row) {
    const double vertical = 180 * (row + 0.5) / kRows;
    const double area = 2 * SinDegrees(90.0 / kRows) * SinDegrees(vertical) * 2 * kPi / kColumns;
    for (int column = 0; column < kColumns; ++column) {
      const double horizontal = 360 * (column + 0.5) / kColumns;
      sum += double{profile.Intensity(DirectionAt(vertical, horizontal))} * area;
    }
  }
  EXPECT_NEAR(profile.Flux() / sum, 1, 1e-4);
}

TEST(IesProfile, DrawsWithTheDensityThatItSays) {
  const IesProfile profile = Uneven();
  UniformNumbers random(3);
  int edges = 0;
  double flux = 0;
  for (int i = 0; i < 100000; ++i) {
    const IesProfile::Sample drawn = profile.Draw(random.NextPair());
    ASSERT_GT(drawn.pdf, 0);
    ASSERT_NEAR(Length(drawn.w), 1, 1e-6);
    if (std::abs(profile.Pdf(drawn.w) / drawn.pdf - 1) > 1e-4f) ++edges;
    flux += double{profile.Intensity(drawn.w) / drawn.pdf} / 100000;
  }
  EXPECT_LT(edges, 20);
  EXPECT_NEAR(flux / profile.Flux(), 1, 0.01);
}

// P1: over cells of equal solid angle.
TEST(IesProfile, DirectionsFollowTheDensity) {
  constexpr size_t kRings = 16, kSectors = 24;
  constexpr int kSteps = 40, kSamples = 1000000;
  const IesProfile profile = Uneven();
  std::vector<double> shares(kRings * kSectors);
  double sum = 0;
  for (size_t cell = 0; cell < shares.size(); ++cell) {
    for (int i = 0; i < kSteps * kSteps; ++i) {
      const double ring = static_cast<double>(cell / kSectors) + (i / kSteps + 0.5) / kSteps;
      const double sector = static_cast<double>(cell % kSectors) + (i % kSteps + 0.5) / kSteps;
      const double cosine = 1 - 2 * ring / kRings;
      const double vertical = Acos(cosine) * 180 / kPi;
      shares[cell] += double{profile.Pdf(DirectionAt(vertical, 360 * sector / kSectors))};
    }
    shares[cell] *= 4 * kPi / (static_cast<double>(shares.size()) * kSteps * kSteps);
    sum += shares[cell];
  }
  EXPECT_NEAR(sum, 1, 2e-3);
  for (double& share : shares) share /= sum;

  UniformNumbers random(4);
  std::vector<uint64_t> counts(shares.size());
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 w = profile.Draw(random.NextPair()).w;
    const double turn = Atan2(double{w.y}, double{w.x}) / (2 * kPi);
    const auto ring = static_cast<size_t>((1 - double{w.z}) / 2 * kRings);
    const auto sector = static_cast<size_t>((turn < 0 ? turn + 1 : turn) * kSectors);
    ++counts[std::min(ring, kRings - 1) * kSectors + std::min(sector, kSectors - 1)];
  }
  EXPECT_LT(test::ChiSquareDeviate(counts, shares), test::kLargestDeviate);
}

}  // namespace
}  // namespace candela
