// Light goes through the holes of a surface, whoever looks for it: sampled lights, rays, both.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::Estimate;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;
using testing_support::kCamera;

/// A wall of albedo 1/2 in z = -2 that the camera sees, and behind the camera, in z = 1, a black
/// veil that covers the part `opacity` of what is behind it: a number, or a texture.
std::string Veiled(const std::string& opacity, const std::string& lights) {
  return fmt::format(
      "{}Textures {{ Texture {{ name weave type checker even 0.5 0.5 0.5 odd 0 0 0 scale 3 3 }} "
      "}}\n"
      "Materials {{ Material {{ name wall type diffuse albedo 0.5 0.5 0.5 }}\n"
      "Material {{ name black type diffuse albedo 0 0 0 }}\n"
      "Material {{ name veil type mask material black opacity {} }} }}\n"
      "Scene {{ Node {{ Component<Object> {{ type plane normal 0 0 1 offset -2 }} "
      "Component<Material> {{ name wall }} }}\n"
      "Node {{ Component<Object> {{ type plane normal 0 0 1 offset 1 }} "
      "Component<Material> {{ name veil }} }}\n{} }}",
      kCamera, opacity, lights);
}

constexpr const char* kPoint =
    "Node { Transform { translate 0 0 3 } Component<Light> { type point attenuation 1 } }";
constexpr const char* kDisk =
    "Node { Transform { translate 0 0 3 } Component<Object> { type disk radius 1 } "
    "Component<Material> { name black } Component<Light> { type area radiance 4 4 4 } }";
constexpr const char* kBall =
    "Node { Transform { translate 0 0 3 } Component<Object> { type sphere radius 1 } "
    "Component<Material> { name black } Component<Light> { type area radiance 4 4 4 } }";
constexpr const char* kSun =
    "Node { Component<Light> { type directional direction 0 0 -1 color 2 2 2 angle 20 } }";

Estimate Seen(const std::string& text, bool next_event = true, uint32_t bounces = 1,
              uint32_t samples = 4096) {
  const auto scene = CompileText(text);
  IntegratorOptions options;
  options.bounces = bounces;
  options.seed = next_event ? 1 : 2;
  PathTechniques techniques;
  techniques.next_event = next_event;
  return EstimateRadiance(PathIntegrator(*scene, options, techniques), {0, 0}, 64, samples);
}

// At distance 5 the point gives 1/25; the wall throws back the part 1/2 over pi.
TEST(CutOut, LetsItsShareOfAPointLightThrough) {
  const double open = 0.5 / M_PI / 25;
  EXPECT_NEAR(Seen(Veiled("0", kPoint)).mean, open, 1e-6);
  EXPECT_NEAR(Seen(Veiled("0.25", kPoint)).mean, 0.75 * open, 1e-6);
  EXPECT_EQ(Seen(Veiled("1", kPoint)).mean, 0);
}

TEST(CutOut, LetsItsShareOfSeveralVeilsThrough) {
  const std::string more =
      "Node { Component<Object> { type sphere radius 20 } Component<Material> { name veil } }\n"
      "Node { Transform { translate 0 0 30 } Component<Light> { type point attenuation 0.001 } }";
  EXPECT_NEAR(Seen(Veiled("0.25", more)).mean, 0.5 / M_PI * 1000 / (32.0 * 32) * 0.75 * 0.75, 1e-4);
}

// A disk of radius 1 at distance 5, and a ball whose middle is there: E = pi L r^2 / (d^2 + r^2),
// and pi L (r / d)^2.
TEST(CutOut, LetsItsShareOfALampThrough) {
  ExpectEstimate(Seen(Veiled("0.25", kDisk)), 0.5 * 4 / 26 * 0.75);
  ExpectEstimate(Seen(Veiled("0.25", kBall)), 0.5 * 4 / 25 * 0.75);
}

TEST(CutOut, LetsItsShareOfASoftSunThrough) {
  ExpectEstimate(Seen(Veiled("0.25", kSun)), 0.5 * 2 / M_PI * 0.75);
}

TEST(CutOut, LetsItsShareOfTheSkyThrough) {
  ExpectEstimate(Seen("Background { color 1 1 1 }\n" + Veiled("0.25", ""), true, 1, 16384),
                 0.5 * 0.75);
}

// Light that a ray finds behind a hole could have been sampled as well: it counts once.
TEST(CutOut, CountsLightOnceWhoeverFindsIt) {
  for (const char* opacity : {"0.25", "texture weave"}) {
    for (const char* light : {kDisk, kBall, kSun}) {
      SCOPED_TRACE(light);
      const Estimate both = Seen(Veiled(opacity, light));
      const Estimate rays = Seen(Veiled(opacity, light), false, 1, 16384);
      const double error = std::sqrt(both.error * both.error + rays.error * rays.error);
      EXPECT_NEAR(both.mean, rays.mean, test::kLargestDeviate * error);
      EXPECT_LE(error, testing_support::LargestError(1e-2) * both.mean);
    }
  }
}

TEST(CutOut, CountsTheLightOfAPictureOnceWhoeverFindsIt) {
  const std::string text =
      "Background { environment assets/cubemap/sky/front.png }\n" + Veiled("0.25", "");
  const Estimate both = Seen(text), rays = Seen(text, false, 1, 16384);
  const double error = std::sqrt(both.error * both.error + rays.error * rays.error);
  EXPECT_NEAR(both.mean, rays.mean, test::kLargestDeviate * error);
  EXPECT_LE(error, testing_support::LargestError(5e-3) * both.mean);
}

// Three veils before a wall that shines: no bounce is needed to see it.
TEST(CutOut, TakesNoBounceFromAPath) {
  std::string veils =
      "Node { Component<Object> { type plane normal 0 0 1 offset -3 } "
      "Component<Material> { name black } Component<Light> { type area radiance 1 1 1 } }\n";
  for (int i = 0; i < 3; ++i) {
    veils += fmt::format(
        "Node {{ Component<Object> {{ type plane normal 0 0 1 offset {} }} "
        "Component<Material> {{ name veil }} }}\n",
        -1 - 0.5 * i);
  }
  const std::string text =
      std::string(kCamera) +
      "Materials { Material { name black type diffuse albedo 0 0 0 }\n"
      "Material { name veil type mask material black opacity 0.25 } }\nScene { " +
      veils + " }";
  ExpectEstimate(Seen(text, true, 0, 16384), 0.75 * 0.75 * 0.75);
}

}  // namespace
}  // namespace candela
