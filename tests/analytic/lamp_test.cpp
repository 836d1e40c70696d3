// A point light over a diffuse plane: E = I cos / d^2.

#include <gtest/gtest.h>

#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "integrators/whitted.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::kCamera;

/// The camera looks at the foot of the perpendicular, (0, 0, -2); the lamp is at height 2, beside
/// it by 3/2: d^2 is 25/4 and the cosine 4/5.
std::string PlaneUnderALamp(const std::string& material) {
  return std::string(kCamera) + "Materials { Material { " + material +
         " } }\n"
         "Scene { Component<Object> { type plane normal 0 0 1 offset -2 } "
         "Component<Material> { index 0 }\n"
         "Node { Transform { translate 1.5 0 0 } "
         "Component<Light> { type point color 10 10 10 attenuation 1 } } }";
}

double Radiance(const Integrator& integrator) {
  return EstimateRadiance(integrator, {0, 0}, 2, 4).mean;
}

// CF3
TEST(PlaneUnderALamp, ReflectsAlbedoTimesIrradianceOverPi) {
  const auto scene = CompileText(PlaneUnderALamp("type diffuse albedo 0.6 0.6 0.6"));
  EXPECT_NEAR(Radiance(PathIntegrator(*scene, {})), 0.244462, 0.244462e-5);
}

// CF3: the course's Phong model has no pi: it shows the irradiance itself.
TEST(PlaneUnderALamp, InTheCoursesModelShowsItsIrradiance) {
  const auto scene = CompileText(PlaneUnderALamp("diffuse 1 1 1"));
  EXPECT_NEAR(Radiance(WhittedIntegrator(*scene, 0, true)), 1.28, 1.28e-5);
}

// CF4: c (N.L) / (alpha d^2): 0.9 / (0.025 * 25) is beyond white, and stays so until the picture is
// written.
TEST(PlaneUnderALamp, InTheCoursesModelAttenuationDividesTheSquareOfTheDistance) {
  const auto scene =
      CompileText(std::string(kCamera) +
                  "Materials { Material { diffuse 1 1 1 } }\n"
                  "Scene { Component<Object> { type plane normal 0 0 1 offset -5 } "
                  "Component<Material> { index 0 }\n"
                  "Component<Light> { type point color 0.9 0.9 0.9 attenuation 0.025 } }");
  EXPECT_NEAR(Radiance(WhittedIntegrator(*scene, 0, false)), 1.44, 1.44e-5);
}

}  // namespace
}  // namespace candela
