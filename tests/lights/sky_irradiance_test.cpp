// Irradiance from skies in closed form.

#include <gtest/gtest.h>

#include "lights/environment_light.h"
#include "math/elementary.h"
#include "tests/lights/irradiance.h"
#include "textures/lat_long.h"

namespace candela {
namespace {

using test::ExpectIrradiance;

/// A sky of fine texels whose radiance is a function of the cosine to the zenith; 0 below.
template <class Radiance>
EnvironmentMap Sky(const Radiance& radiance) {
  constexpr int kWidth = 8, kHeight = 2048;
  Image image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight / 2; ++y) {
    const auto value = static_cast<float>(radiance(Cos(kPi * (y + 0.5) / kHeight)));
    for (float& sample : image.Row(y)) sample = value;
  }
  return EnvironmentMap(image, 1, 0);
}

// The picture's rows are blended across the horizon, by half a row; that is what the tolerance of
// the expectation has to hold: 1e-3 of a percent.
void ExpectUnder(const EnvironmentMap& map, double expected) {
  const EnvironmentLight light(map);
  const auto e = test::IrradianceOf(light, {0, 0, 0}, {0, 1, 0});
  EXPECT_LE(std::abs(e.mean - expected), test::kLargestDeviate * e.error + 2e-5 * expected);
  EXPECT_LE(e.error, 1e-3 * expected);
}

// CF10
TEST(OpenSky, GivesPi) {
  ExpectUnder(Sky([](double) { return 1; }), kPi);
}

// CF11: L = Lz (1 + 2 cos) / 3: 7 pi Lz / 9.
TEST(OvercastSky, GivesSevenNinthsOfPi) {
  ExpectUnder(Sky([](double cosine) { return (1 + 2 * cosine) / 3; }), 2.443461);
}

// CF11
TEST(CosineSky, GivesTwoThirdsOfPi) {
  ExpectUnder(Sky([](double cosine) { return cosine; }), 2.094395);
}

// CF10: a plane that leans by phi against a sky of the upper half sees (1 + cos phi) / 2 of it: the
// same as behind a long wall that rises at that angle.
TEST(LeaningPlane, SeesHalfOfOnePlusCosineOfTheSky) {
  const EnvironmentMap map = Sky([](double) { return 1; });
  const EnvironmentLight light(map);
  const double root = std::sqrt(0.5);
  const Vec3 n{static_cast<float>(root), static_cast<float>(root), 0};
  const auto e = test::IrradianceOf(light, {0, 0, 0}, n, 65536);
  EXPECT_LE(std::abs(e.mean - 2.681517), test::kLargestDeviate * e.error + 2e-4);
  EXPECT_LE(e.error, 1e-3 * 2.681517);
}

}  // namespace
}  // namespace candela
