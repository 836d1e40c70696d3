// What level ground gets from the sky of a scene and its sun, by the whole path integrator, against
// an integral of the model over the sky.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "math/elementary.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"
#include "textures/daylight.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;

constexpr double kElevation = 35, kAzimuth = 50, kScale = 0.25;

Vec3 ToSun() {
  return ToFloat(Vec3d{SinDegrees(kAzimuth) * CosDegrees(kElevation), SinDegrees(kElevation),
                       -CosDegrees(kAzimuth) * CosDegrees(kElevation)});
}

/// The red irradiance of level ground without the sun.
double FromSky(const Daylight& daylight) {
  constexpr int kRings = 300, kSectors = 600;
  double sum = 0;
  for (int i = 0; i < kRings; ++i) {
    const double cosine = std::sqrt((i + 0.5) / kRings);  // Rings of equal irradiance.
    const double sine = std::sqrt(1 - cosine * cosine);
    for (int k = 0; k < kSectors; ++k) {
      const double turn = 360 * (k + 0.5) / kSectors;
      const Vec3d w{SinDegrees(turn) * sine, cosine, -CosDegrees(turn) * sine};
      sum += double{daylight.SkyRadiance(ToFloat(w)).x};
    }
  }
  return sum * kPi / (kRings * kSectors);
}

/// A white floor that the camera looks at from above.
std::string FloorUnder(const std::string& sky) {
  return "Camera { center 0 3 0  direction 0 -1 0  up 0 0 -1  fov 30 }\n"
         "Background { sky daylight turbidity 3 sun_elevation 35 sun_azimuth 50 scale 0.25 " +
         sky +
         " }\nMaterials { Material { type diffuse albedo 1 1 1 } }\n"
         "Scene { Component<Material> { index 0 } "
         "Component<Object> { type plane normal 0 1 0 offset 0 } }\n";
}

void ExpectFloor(const std::string& sky, double irradiance) {
  const auto scene = CompileText(FloorUnder(sky));
  IntegratorOptions options;
  options.bounces = 1;
  options.seed = 5;
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, options), {0, 0}, 128, 4096),
                 irradiance / kPi);
}

TEST(FloorUnderDaylight, GetsTheIntegralOfTheSky) {
  ExpectFloor("sun false", kScale * FromSky(Daylight(3, ToSun())));
}

TEST(FloorUnderDaylight, GetsTheSunByTheSineOfItsElevation) {
  const Daylight daylight(3, ToSun());
  const double sun = double{daylight.SunIrradiance().x} * SinDegrees(kElevation);
  EXPECT_GT(sun, FromSky(daylight)) << "it is the brighter of the two";
  ExpectFloor("", kScale * (FromSky(daylight) + sun));
}

// Whitted takes its light as parallel, and rays see the sky, without the disk.
TEST(Whitted, HasTheSunAsALight) {
  const auto scene = CompileText(FloorUnder(""));
  ASSERT_EQ(scene->lights().size(), 1u);
  const LightSample sun = scene->lights()[0]->SampleIncident({0, 0, 0});
  EXPECT_GT(Dot(sun.direction, ToSun()), 1 - 1e-6f);
  const Rgb expected = Daylight(3, ToSun()).SunIrradiance() * static_cast<float>(kScale);
  for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(sun.radiance[c], expected[c]);

  const auto without = CompileText(FloorUnder("sun false"));
  EXPECT_TRUE(without->lights().empty());
  const Vec3 beside = Normalize(ToSun() + Vec3{0, 0.02f, 0});
  EXPECT_EQ(scene->background().Radiance(beside), without->background().Radiance(beside));
}

// The disk is seen by rays at its true size, as bright as its irradiance asks for.
TEST(Sun, IsSeenAsADisk) {
  const auto scene = CompileText(FloorUnder(""));
  const Light& sun = *scene->lights()[0];
  const Vec3 side = Normalize(Cross(ToSun(), Vec3{0, 1, 0}));
  const auto seen = [&](double degrees) {
    const Vec3 w = Normalize(ToSun() + side * static_cast<float>(TanDegrees(degrees)));
    return sun.Emitted({}, -w);
  };
  EXPECT_TRUE(seen(0.27).IsBlack());
  const double sine = SinDegrees(0.533 / 2);
  const double irradiance = double{sun.SampleIncident({}).radiance[1]};
  EXPECT_NEAR(double{seen(0.26)[1]} * kPi * sine * sine / irradiance, 1, 1e-4);
}

}  // namespace
}  // namespace candela
