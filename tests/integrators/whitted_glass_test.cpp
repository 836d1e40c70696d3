// Refraction in whitted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "integrators/distribution.h"
#include "integrators/distribution_draws.h"
#include "math/elementary.h"
#include "tests/integrators/one_ray.h"
#include "tests/support/estimate.h"

namespace candela::test {
namespace {

using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;

// A plate of glass of thickness 1, one unit away, before a white sky: head-on all that is not
// absorbed comes through or back, 0.96 of it straight.
TEST(Refraction, ReflectsByFresnelAndAbsorbsByBeer) {
  const std::string glass =
      "Background { color 1 1 1 } Materials { Material { diffuse 0 0 0 "
      "transmittance 1 1 1 ior 1.5 absorption 0 0.5 1 } }"
      "Scene { Node { Component<Object> { type plane normal 0 0 1 offset -1 } "
      "Component<Material> { index 0 } } "
      "Node { Component<Object> { type plane normal 0 0 -1 offset 2 } "
      "Component<Material> { index 0 } }";
  // The fraction that two bounces let out: through both faces, or back from the first, and what
  // comes back from the second needs a third.
  const auto two = [](double a) { return 0.04 + 0.96 * 0.96 * a; };
  ExpectColor(Trace(glass, Bounces(2)).color,
              {static_cast<float>(two(1)), static_cast<float>(two(std::exp(-0.5))),
               static_cast<float>(two(std::exp(-1.0)))},
              1e-5f);
  const auto three = [&](double a) { return two(a) + 0.96 * 0.04 * a * 0.96 * a; };
  ExpectColor(Trace(glass, Bounces(3)).color,
              {static_cast<float>(three(1)), static_cast<float>(three(std::exp(-0.5))),
               static_cast<float>(three(std::exp(-1.0)))},
              1e-5f);
  ExpectColor(Trace(glass, Bounces(0)).color, {0, 0, 0});
}

// CF19: with all inner bounces 0.559308 goes through a plate of the optical depth 0.5, and 0.053569
// comes back; before a sky that is as bright on both sides both are seen. After four bounces one of
// two ways is drawn, by which less than a thousandth goes.
TEST(Refraction, OfAPlateHasAllInnerBounces) {
  const auto scene = SceneOf(
      "Background { color 1 1 1 } Materials { Material { diffuse 0 0 0 transmittance 1 1 1 "
      "absorption 0.5 0 0 } } Scene { Node { Component<Object> { type plane normal 0 0 1 offset -1 "
      "} Component<Material> { index 0 } } Node { Component<Object> { type plane normal 0 0 -1 "
      "offset 2 } Component<Material> { index 0 } }");
  const auto seen = EstimateRadiance(DistributionIntegrator(*scene, Bounces(60)), {0, 0}, 16, 64);
  EXPECT_LE(seen.error, 1e-6);
  EXPECT_NEAR(seen.mean, 0.559308 + 0.053569, 4 * seen.error + 1e-6);
}

// A mirror within glass that takes light away. Beyond the first surfaces one of two ways is drawn,
// and the sum of those with at most eight bounces is 0.5 (1 - 0.9^8) / (1 + 0.9).
TEST(Refraction, BesideAReflectionThatTakesLightAwayKeepsTheMean) {
  const auto scene = SceneOf(
      "Background { color 0.5 0.5 0.5 } Materials { Material { diffuse 0 0 0 specular -0.9 -0.9 "
      "-0.9 transmittance 1 1 1 ior 1.000001 } } Scene { Component<Object> { type sphere radius 9 "
      "} Component<Material> { index 0 }");
  const auto seen = EstimateRadiance(DistributionIntegrator(*scene, Bounces(8)), {0, 0}, 256, 512);
  EXPECT_NEAR(seen.mean, 0.149877, 4 * seen.error + 1e-6);
  EXPECT_LT(4 * seen.error, testing_support::LargestError(0.02));
}

// Snell's law, by the ray: through water of depth 1 a stripe of the ground is seen where
// x = tan(i) + tan(r), with sin(i) = 1.33 sin(r).
TEST(Refraction, BendsRaysBySnellsLaw) {
  for (const double slope : {0.25, 0.5, 1.0}) {
    const double sine = slope / std::sqrt(1 + slope * slope) / 1.33;
    const double x = slope + sine / std::sqrt(1 - sine * sine);
    const auto stripe = [&](double from, double to) {
      return fmt::format(
          "Background {{ ambient_light 1 1 1 }} Materials {{ Material {{ diffuse 0 0 0 "
          "transmittance 1 1 1 ior 1.33 }} Material {{ diffuse 1 1 1 }} }}"
          "Scene {{ Node {{ Component<Object> {{ type plane normal 0 0 1 offset -1 }} "
          "Component<Material> {{ index 0 }} }} Node {{ Component<Object> {{ type triangle vertex0 "
          "{0} -9 -2 vertex1 {1} -9 -2 vertex2 {0} 900 -2 }} Component<Material> {{ index 1 }} }}",
          from, to);
    };
    const Vec2 point{static_cast<float>(slope), 0};
    EXPECT_GT(Trace(stripe(x - 1e-4, x + 1), Bounces(1), point).color.x, 0.9f);
    EXPECT_EQ(Trace(stripe(x + 1e-4, x + 1), Bounces(1), point).color.x, 0);
  }
}

TEST(Refraction, BeyondTheCriticalAngleReflectsAll) {
  const Vec3 flat = Normalize(Vec3{1, 0, -0.5f});
  EXPECT_EQ(Refract(flat, {0, 0, 1}, 1 / 1.5f).reflectance, 1);
  EXPECT_NEAR(Refract({0, 0, -1}, {0, 0, 1}, 1 / 1.5f).reflectance, 0.04, 1e-6);
  const Refraction bent = Refract(Normalize(Vec3{0.6f, 0, -0.8f}), {0, 0, 1}, 1.5f);
  EXPECT_NEAR(bent.direction.x, 0.4, 1e-6);
  EXPECT_NEAR(LengthSquared(bent.direction), 1, 1e-6);
}

// Clear glass before an even sky is not seen, whatever the angle: the two parts make a whole. The
// tree has 4 forks on each way, then one of the two ways is drawn.
TEST(Refraction, ClearGlassIsNotSeenBeforeAnEvenSky) {
  const auto scene = SceneOf(
      "Background { color 1 1 1 } Materials { Material { diffuse 0 0 0 transmittance 1 1 1 } }"
      "Scene { Node { Transform { translate 0 0 -3 } Component<Object> { type sphere radius 1 } "
      "Component<Material> { index 0 } }");
  const DistributionIntegrator integrator(*scene, Bounces(200));
  for (const float x : {0.0f, 0.1f, 0.2f, 0.3f}) {
    const Seen seen = Trace(integrator, {x, 0.05f});
    ExpectColor(seen.color, {1, 1, 1}, 2e-5f);
    EXPECT_LT(seen.rays.Total(), 2000u);
  }
}

}  // namespace
}  // namespace candela::test
