// How bright a ball is as a whole.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "math/elementary.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"
#include "tests/support/render_scene.h"

namespace candela {
namespace {

using testing_support::Estimate;

/// The mean of a picture, from pictures with random numbers of their own.
Estimate MeanOfPicture(const Integrator& integrator, RenderOptions options) {
  constexpr uint32_t kRuns = 8;
  double sum = 0, squares = 0;
  for (uint32_t run = 0; run < kRuns; ++run) {
    options.seed = run;
    const Image image = testing_support::RenderImage(integrator, options);
    double mean = 0;
    for (int64_t i = 0; i < image.PixelCount(); ++i) {
      mean += static_cast<double>(image.Samples()[static_cast<size_t>(3 * i)]);
    }
    mean /= static_cast<double>(image.PixelCount());
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / kRuns;
  return {mean, std::sqrt(std::max(0.0, squares / kRuns - mean * mean) / (kRuns - 1))};
}

// CF15: seen from where the light comes from, a diffuse ball is bright in its middle and dark at
// its rim; the mean over its disk is 2/3 rho E / pi. It is so far away that rays are parallel,
// nearly.
TEST(FullMoon, IsTwoThirdsAsBrightAsAFlatDisk) {
  constexpr double kDistance = 1e4, kReach = 1.25;
  const auto scene = testing_support::CompileText(fmt::format(
      "Camera {{ center 0 0 {0} direction 0 0 -1 up 0 1 0 fov {1} }}\n"
      "Materials {{ Material {{ type diffuse albedo 1 1 1 }} }}\n"
      "Scene {{ Component<Object> {{ type sphere radius 1 }} Component<Material> {{ index 0 }}\n"
      "Component<Light> {{ type directional direction 0 0 -1 color {2:.9g} {2:.9g} {2:.9g} }} }}",
      kDistance, 2 * std::atan(kReach / kDistance) * 180 / kPi, kPi));
  IntegratorOptions direct;
  direct.bounces = 1;
  RenderOptions options = testing_support::WholePicture(32, 32);
  options.grid = PixelGrid::kCentres;
  options.pattern = SamplePattern::kFilter;
  options.samples = 256;
  const Estimate estimate = MeanOfPicture(PathIntegrator(*scene, direct), options);
  const double share = kPi / (4 * kReach * kReach);
  const double mean = estimate.mean / share, error = estimate.error / share;
  // Over the disk the rays lean by up to 1 / distance.
  EXPECT_NEAR(mean, 2 / 3.0, test::kLargestDeviate * error + 1 / kDistance);
  EXPECT_LE(error, 1e-3 * mean);
}

}  // namespace
}  // namespace candela
