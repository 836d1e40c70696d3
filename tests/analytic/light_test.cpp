// What surfaces send to the camera under lights in closed form, by the whole path integrator: with
// lights sampled, and with rays alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "image/image_file.h"
#include "integrators/path.h"
#include "integrators/registry.h"
#include "math/elementary.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;

/// A white floor z = 0 that the camera sees from the side, where no lamp is in the way, and a lamp.
/// The camera looks at the origin.
std::string FloorUnder(const std::string& lamp) {
  const bool has_surface = lamp.find("Component<Object>") != std::string::npos;
  const std::string black = has_surface ? "Component<Material> { index 1 } " : "";
  return "Camera { center 0 -4 0.5  direction 0 4 -0.5  up 0 0 1  fov 30 }\n"
         "Materials { Material { type diffuse albedo 1 1 1 } Material { type diffuse albedo 0 0 0 "
         "} "
         "}\n"
         "Scene { Node { Component<Material> { index 0 } "
         "Component<Object> { type plane normal 0 0 1 offset 0 } }\n"
         "Node { " +
         black + lamp + " } }";
}

IntegratorOptions OneBounce() {
  IntegratorOptions options;
  options.bounces = 1;
  options.seed = 3;
  return options;
}

/// The irradiance of the floor: its radiance is E / pi.
void ExpectFloor(const std::string& lamp, double irradiance, uint32_t samples = 1024) {
  const auto scene = CompileText(FloorUnder(lamp));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, OneBounce()), {0, 0}, 128, samples),
                 irradiance / kPi);
}

// Of a lamp 2 above whose light falls off as 1 + 0.5 D + 0.25 D^2.
TEST(FloorUnderAPointLight, GetsWhatItsFalloffLeaves) {
  ExpectFloor(
      "Transform { translate 0 0 2 } Component<Light> { type point color 6 6 6 falloff 1 0.5 0.25 "
      "}",
      2);
  ExpectFloor(
      "Transform { translate 0 0 2 } Component<Light> { type spot direction 0 0 -1 angle 60 color "
      "6 6 6 falloff 3 0 0 }",
      2);
}

// CF5
TEST(FloorUnderASphere, GetsPiLTimesSquaredSine) {
  ExpectFloor(
      "Transform { translate 0 0 3 } Component<Object> { type sphere radius 1 } "
      "Component<Light> { type area radiance 5 5 5 }",
      1.745329);
}

// CF7
TEST(FloorUnderADisk, GetsTheClosedForm) {
  ExpectFloor(
      "Transform { translate 0 0 2 } Component<Object> { type disk radius 1 } "
      "Component<Light> { type area radiance 3 3 3 }",
      1.884956);
}

// CF8
TEST(FloorUnderARectangle, GetsTheClosedForm) {
  ExpectFloor(
      "Transform { translate 0 0 1 } Component<Object> { type rectangle width 2 height 2 } "
      "Component<Light> { type area radiance 1 1 1 }",
      1.740840);
}

// CF9
TEST(FloorUnderATriangle, GetsLambertsSum) {
  ExpectFloor(
      "Component<Object> { type triangle vertex0 1 0 1 vertex1 -0.5 1 2 vertex2 0 -1 1.5 } "
      "Component<Light> { type area radiance 1 1 1 }",
      0.491770);
}

TEST(FloorUnderASoftSun, GetsItsColourTimesCosineWhateverItsAngle) {
  for (const double angle : {0.0, 0.53, 40.0}) {
    ExpectFloor(fmt::format("Component<Light> {{ type directional direction 0.6 0 -0.8 "
                            "color 2 2 2 angle {} }}",
                            angle),
                1.6);
  }
}

TEST(FloorUnderASpot, GetsIntensityOverSquaredDistance) {
  ExpectFloor(
      "Transform { translate 0 0 2 } Component<Light> { type spot direction 0 0 -1 "
      "angle 30 color 8 8 8 attenuation 1 }",
      2, 16);
}

// CF10: a long black wall rises from here at 45 degrees: of the light of an even sky (1 + cos 45) /
// 2 is left.
TEST(FloorBesideAWall, SeesThePartOfTheSkyThatTheWallLeaves) {
  const std::string wall =
      "Transform { translate 1e-4 0 0  y_rotate -45  translate 50000 0 0 } "
      "Component<Object> { type rectangle width 100000 height 200000 }";
  const auto scene =
      CompileText("Background { color 1 1 1 ambient_light 0 0 0 }\n" + FloorUnder(wall));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, OneBounce()), {0, 0}, 128, 2048),
                 2.681517 / kPi);
}

// A picture of the sky without any light is no light: it is never chosen, and the lamp gives what
// it gives alone.
TEST(BlackSky, AddsNothingToALamp) {
  const testing_support::TempFolder folder;
  for (const int size : {1, 8}) {
    const auto picture = EncodeImage(Image(2 * size, size, 3, 0.0f), ImageFormat::kPfm);
    testing_support::Put(folder / "black.pfm", *picture);
    const std::string sky = "Background { environment black.pfm }\n";
    const auto dark = CompileText(sky + FloorUnder(""), folder.path());
    const auto seen = EstimateRadiance(PathIntegrator(*dark, OneBounce()), {0, 0}, 4, 64);
    EXPECT_EQ(seen.mean, 0);
    const auto lit = CompileText(
        sky + FloorUnder("Transform { translate 0 0 2 } Component<Object> { type disk radius 1 } "
                         "Component<Light> { type area radiance 3 3 3 }"),
        folder.path());
    ExpectEstimate(EstimateRadiance(PathIntegrator(*lit, OneBounce()), {0, 0}, 128, 1024),
                   1.884956 / kPi);
  }
}

// CF13: L1 = Le / (1 - r1 r2), L2 = r2 L1: two parallel planes without end, one of which emits.
TEST(ParallelPlanes, ExchangeLightAsAGeometricSeries) {
  const auto expect_seen = [](const char* direction, double expected) {
    const auto scene = CompileText(std::string("Camera { center 0 0 0 direction ") + direction +
                                   " up 0 1 0 fov 90 }\n"
                                   "Materials { Material { type diffuse albedo 0.3 0.3 0.3 } "
                                   "Material { type diffuse albedo 0.8 0.8 0.8 } }\n"
                                   "Scene { Node { Component<Material> { index 0 } "
                                   "Component<Object> { type plane normal 0 0 1 offset -1 } "
                                   "Component<Light> { type area radiance 1 1 1 } }\n"
                                   "Node { Component<Material> { index 1 } "
                                   "Component<Object> { type plane normal 0 0 1 offset 1 } } }");
    IntegratorOptions options;
    options.seed = 5;
    ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, options), {0, 0}, 128, 1024), expected);
  };
  expect_seen("0 0 -1", 1.315789);
  expect_seen("0 0 1", 1.052632);
}

}  // namespace
}  // namespace candela
