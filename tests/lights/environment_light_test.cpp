#include "lights/environment_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/elementary.h"
#include "sampling/warp.h"
#include "tests/sampling/chi_square.h"
#include "textures/lat_long.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

/// A dim sky with a dark ground, a bright window and a sun of a single texel.
EnvironmentMap Sky(float rotate_degrees) {
  constexpr int kWidth = 32, kHeight = 16;
  Image image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool is_window = y > 4 && y < 8 && x > 10 && x < 15;
      const float value = y >= 10 ? 0 : is_window ? 5 : 0.2f + 0.01f * static_cast<float>(y);
      image.At(x, y, 0) = value;
      image.At(x, y, 1) = value * 0.5f;
      image.At(x, y, 2) = value * 2;
    }
  }
  image.At(25, 3, 0) = 200;
  return EnvironmentMap(image, 2, rotate_degrees);
}

// P1: cells of a grid in longitude and latitude as fine as the picture: with their shares by
// quadrature of the density.
TEST(EnvironmentLight, FollowsItsDensityAndReachesWhatItSays) {
  for (const float rotate : {0.0f, 30.0f, -400.0f}) {
    const EnvironmentMap map = Sky(rotate);
    const EnvironmentLight light(map);
    constexpr size_t kColumns = 32, kRows = 16, kFine = 12;
    // Where columns of the grid lie on those of the picture the density is constant over cells.
    const float turn = map.Turn();
    std::vector<double> shares(kColumns * kRows);
    double integral = 0;
    for (size_t y = 0; y < kRows * kFine; ++y) {
      for (size_t x = 0; x < kColumns; ++x) {
        const Vec2 place{(static_cast<float>(x) + 0.5f) / kColumns,
                         (static_cast<float>(y) + 0.5f) / (kRows * kFine)};
        const double upper = Cos(kPi * static_cast<double>(y) / (kRows * kFine));
        const double lower = Cos(kPi * static_cast<double>(y + 1) / (kRows * kFine));
        const Vec3 w = DirectionOfLatLong(TurnLatLong(place, -turn));
        const double share = static_cast<double>(light.PdfIncident({}, {}, w)) * 2 * kPi /
                             kColumns * (upper - lower);
        shares[y / kFine * kColumns + x] += share;
        integral += share;
      }
    }
    EXPECT_NEAR(integral, 1, 1e-3);
    for (double& share : shares) share /= integral;

    UniformNumbers numbers(1);
    std::vector<uint64_t> counts(kColumns * kRows);
    int exact = 0;
    constexpr int kSamples = 1000000;
    for (int i = 0; i < kSamples; ++i) {
      const LightSample sample = light.SampleIncident({}, numbers.NextPair());
      if (sample.pdf == 0) continue;
      const Vec2 place = TurnLatLong(LatLongOf(sample.direction), turn);
      const auto x = std::min(static_cast<size_t>(place.x * kColumns), kColumns - 1);
      const auto y = std::min(static_cast<size_t>(place.y * kRows), kRows - 1);
      ++counts[y * kColumns + x];
      if (i % 100 != 0) continue;
      ASSERT_EQ(light.Emitted({}, -sample.direction), sample.radiance);
      const float pdf = light.PdfIncident({}, {}, sample.direction);
      exact += std::abs(pdf / sample.pdf - 1) < 1e-3f;
    }
    EXPECT_GT(exact, kSamples / 100 * 0.999) << "at the edges of texels rounding decides";
    // Strays over the edges of cells, by rounding.
    for (size_t i = 0; i < counts.size(); ++i) {
      if (shares[i] < 1e-9) {
        EXPECT_LT(counts[i], 10u);
        counts[i] = 0;
        shares[i] = 0;
      }
    }
    EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate) << rotate;
  }
}

// Radiance over density: so little varies that the estimate of what comes from everywhere is exact
// to a few percent of a sample's standard deviation.
TEST(EnvironmentLight, DrawsBrightDirectionsMoreOften) {
  const EnvironmentMap map = Sky(0);
  const EnvironmentLight light(map);
  UniformNumbers numbers(2);
  double sum = 0, squares = 0;
  constexpr int kSamples = 100000;
  for (int i = 0; i < kSamples; ++i) {
    const LightSample sample = light.SampleIncident({}, numbers.NextPair());
    if (sample.pdf == 0) continue;
    const double value =
        static_cast<double>(MeanOf(sample.radiance.ToRgb())) / static_cast<double>(sample.pdf);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kSamples;
  EXPECT_LT(squares / kSamples - mean * mean, 0.5 * mean * mean);
  // Its reach is pi times the mean radiance, and the sum is 4 pi times that.
  EXPECT_NEAR(mean / 4, static_cast<double>(light.Reach().power), 0.01 * mean / 4);
}

TEST(EnvironmentLight, OfABlackSkyHasNoPower) {
  const EnvironmentMap map(Image(4, 2, 3), 1, 0);
  EXPECT_EQ(EnvironmentLight(map).Reach().power, 0.0f);
}

}  // namespace
}  // namespace candela
