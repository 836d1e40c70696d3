// Light that bodies split into its colours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "materials/dispersion.h"
#include "math/wavelength.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;

constexpr const char* kCauchy = "cauchy 1.2 0.1 0";  // From 1.41 to 1.86: no glass is so strong.

/// The camera looks straight down into a sea, at its ground, which glows.
std::string Sea(const std::string& material, const std::string& interior) {
  return fmt::format(
      "Camera {{ center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 }}\n"
      "Media {{ Medium {{ name sea {} }} }}\n"
      "Materials {{ Material {{ name black type diffuse albedo 0 0 0 }}\n"
      "Material {{ name water type dielectric {} }} }}\n"
      "Scene {{ Node {{ Component<Object> {{ type plane normal 0 0 1 offset 0 }}\n"
      "Component<Material> {{ name water }} {} }}\n"
      "Node {{ Component<Object> {{ type plane normal 0 0 1 offset -1 }}\n"
      "Component<Material> {{ name black }} Component<Light> {{ type area radiance 1 1 1 }} }} }}",
      kCauchy, material, interior);
}

/// What is seen of radiance 1 below: (1 - r) / n^2 with Fresnel's r, in the mean over red light.
double RedThroughTheSurface() {
  constexpr int kSteps = 100000;
  const Dispersion sea = Dispersion::Cauchy({1.2f, 0.1f, 0});
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const float wavelength = SampleWavelength((static_cast<float>(i) + 0.5f) / kSteps);
    const auto n = static_cast<double>(sea.At(wavelength));
    const double r = (n - 1) / (n + 1);
    sum += static_cast<double>(ColourOf(wavelength)[0]) * (1 - r * r) / (n * n) / kSteps;
  }
  return sum;
}

TEST(PathsThroughDispersion, SeeTheMeanOverWavelengths) {
  for (const std::string& text :
       {Sea(kCauchy, ""), Sea("", "Component<Interior> { medium sea }")}) {
    const auto scene = CompileText(text);
    ASSERT_TRUE(scene->HasDispersion());
    ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, {}), {0, 0}, 256, 4096),
                   RedThroughTheSurface());
  }
}

// P4: split light is white where it comes from everywhere.
TEST(PathsThroughDispersion, SeeNothingInTheFurnace) {
  for (const char* roughness : {"0", "0.4"}) {
    const auto scene = CompileText(
        fmt::format("Camera {{ center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 }}\n"
                    "Background {{ color 1 1 1 }}\n"
                    "Materials {{ Material {{ name glass type dielectric {} roughness {} }} }}\n"
                    "Scene {{ Component<Object> {{ type sphere radius 1 }} Component<Material> {{ "
                    "index 0 }} }}",
                    kCauchy, roughness));
    const auto seen = EstimateRadiance(PathIntegrator(*scene, {}), {0.2f, 0.1f}, 256, 2048);
    EXPECT_NEAR(seen.mean, 1, testing_support::LargestError(roughness[1] == 0 ? 2e-3 : 5e-3))
        << roughness;
    EXPECT_LE(seen.error, testing_support::LargestError(1e-3));
  }
}

TEST(PathsThroughDispersion, ScenesWithoutItHaveNone) {
  const auto scene = CompileText(
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 }\n"
      "Materials { Material { name glass type dielectric ior 1.5 } }\n"
      "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }");
  EXPECT_FALSE(scene->HasDispersion());
}

}  // namespace
}  // namespace candela
