// Where things seem to be that are seen through glass and water.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optics/bright_scene.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

/// The mean radiance that the path integrator sees through an image point.
testing_support::Estimate Through(const Scene& scene, Vec2 image_point) {
  IntegratorOptions options;
  options.seed = 9;
  options.bounces = 8;
  return testing_support::EstimateRadiance(PathIntegrator(scene, options), image_point, 64, 1024);
}

/// A shining strip across the view at a distance of 10, between these x.
std::string Strip(double from, double to) {
  return test::Shining(fmt::format("translate {:.9g} 0 -10", (from + to) / 2),
                       fmt::format("rectangle width {:.9g} height 1", to - from));
}

// CF20: s = t sin i (1 - cos i / sqrt(n^2 - sin^2 i)), for a pane of n = 1.5 and thickness 1 at 45
// degrees 0.329142. The ray goes on in its direction: a strip as narrow as two ten-thousandths is
// seen through it there, with what two faces let through, and nothing is seen beside it.
TEST(GlassPlate, ShiftsTheViewByTheClosedForm) {
  const std::string faces =
      "Node { Transform { translate 0 0 -3 y_rotate 45 } Component<Material> { index 1 }\n"
      "Component<Object> { type plane normal 0 0 1 offset 0.5 } }\n"
      "Node { Transform { translate 0 0 -3 y_rotate 45 } Component<Material> { index 1 }\n"
      "Component<Object> { type plane normal 0 0 -1 offset 0.5 } }\n";
  constexpr double kShift = 0.329142;
  const auto seen_between = [&](double from, double to) {
    const auto scene = test::SceneOf(faces + Strip(from, to), 90, "", "type dielectric ior 1.5");
    return Through(*scene, {0, 0});
  };
  // Light that is reflected between the faces comes out beside the strip.
  const double r = 0.0502399;
  testing_support::ExpectEstimate(seen_between(-kShift - 1e-4, -kShift + 1e-4), (1 - r) * (1 - r));
  EXPECT_EQ(seen_between(-kShift + 1e-4, -kShift + 0.1).mean, 0);
  EXPECT_EQ(seen_between(-kShift - 0.1, -kShift - 1e-4).mean, 0);
}

// CF20: seen from above, what lies at depth d in water seems to lie at d / 1.33.
TEST(Water, MakesItsGroundSeemNearer) {
  // The surface is 4 units away, the ground 10: a depth of 6 that seems to be 4.511278.
  const std::string surface =
      "Node { Component<Material> { index 1 }\n"
      "Component<Object> { type plane normal 0 0 1 offset -4 } }\n";
  constexpr float kSlope = 0.02f;
  const double seen_at = static_cast<double>(kSlope) * (4 + 6 * 0.751880);
  const auto seen_between = [&](double from, double to) {
    const auto scene = test::SceneOf(surface + Strip(from, to), 90, "", "type dielectric ior 1.33");
    return Through(*scene, {kSlope, 0});
  };
  // Radiance grows by n^2 on its way into water and falls as much on its way out.
  const double through = (1 - 0.0200593) * 1.0;
  const double tolerance = 1e-3 * seen_at;
  const auto there = seen_between(seen_at - tolerance, seen_at + tolerance);
  EXPECT_NEAR(there.mean * 1.33 * 1.33, through, 5e-3);
  EXPECT_EQ(seen_between(seen_at + tolerance, 1).mean, 0);
  EXPECT_EQ(seen_between(-1, seen_at - tolerance).mean, 0);
}

}  // namespace
}  // namespace candela
