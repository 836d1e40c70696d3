// Fog in whitted.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/integrators/one_ray.h"
#include "tests/support/compile_text.h"

namespace candela::test {
namespace {

using testing_support::CompileText;

// CF28: the wall is two units away.
TEST(Fog, TakesThePlaceOfWhatItHides) {
  const std::string fog =
      "ambient_light 1 1 1 fog homogeneous fog_density 0.7 fog_color 0.5 0.25 0";
  const auto left = 0.246597f;
  ExpectColor(Trace(Wall("diffuse 1 1 1", fog), {}).color,
              {left + (1 - left) * 0.5f, left + (1 - left) * 0.25f, left});
}

TEST(Fog, HidesTheBackground) {
  EXPECT_EQ(Trace("Background { color 1 1 1 fog homogeneous fog_density 0.01 fog_color 0.5 0.25 0 }"
                  "Scene {",
                  {})
                .color,
            (Rgb{0.5f, 0.25f, 0}));
  // Straight up from one unit above the ground, exp(-exp(-1)) is left.
  const double left = std::exp(-std::exp(-1.0));
  const auto scene = CompileText(
      "Camera { center 0 1 0 direction 0 1 0 up 0 0 1 fov 90 }"
      "Background { color 1 1 1 fog exponential fog_density 1 fog_height 1 fog_color 0 0 0 }"
      "Scene { }");
  EXPECT_NEAR(Trace(**WhittedIntegrator::Create(*scene, {})).color.x, left, 1e-6);
}

// There and back: a mirror two units away shows a wall four units from it.
TEST(Fog, LiesBeforeWhatMirrorsShowToo) {
  const std::string text =
      "Background { ambient_light 1 1 1 fog homogeneous fog_density 0.25 fog_color 0 0 0 }"
      "Materials { Material { diffuse 0 0 0 specular 0.5 0.5 0.5 } Material { diffuse 1 1 1 } }"
      "Scene { Node { Component<Object> { type plane normal 0 0 1 offset -2 } "
      "Component<Material> { index 0 } } Node { Component<Object> { type plane normal 0 0 -1 "
      "offset -2 } Component<Material> { index 1 } }";
  // The mirrored ray begins 0.01 in front of the mirror, as in the course.
  ExpectColor(Trace(text, Bounces(1)).color,
              Rgb{1, 1, 1} * static_cast<float>(0.5 * std::exp(-0.25 * (2 + 3.99))));
}

}  // namespace
}  // namespace candela::test
