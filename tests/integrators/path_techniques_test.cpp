// What changes the variance of path tracing must not change its mean: sampled lights or rays alone,
// weights, the choice of lights, Russian roulette.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::Estimate;
using testing_support::EstimateMean;
using testing_support::EstimateRadiance;

const std::string kCamera = "Camera { center 0 1 4  direction 0 -0.2 -1  up 0 1 0  fov 60 }\n";

/// Objects of several materials on a floor, and what lights them.
std::string StillLife(const std::string& background, const std::string& lights) {
  return kCamera + background +
         "Materials { Material { type diffuse albedo 0.7 0.7 0.7 } Material { type mirror } "
         "Material { type dielectric ior 1.5 absorption 0.2 0.1 0 } "
         "Material { type conductor metal gold roughness 0.4 } "
         "Material { type dielectric ior 1.4 roughness 0.5 } }\n"
         "Scene { Node { Component<Object> { type plane normal 0 1 0 offset -1 } "
         "Component<Material> { index 0 } }\n"
         "Node { Transform { translate -1.2 -0.3 -1 } Component<Object> { type sphere radius 0.7 } "
         "Component<Material> { index 1 } }\n"
         "Node { Transform { translate 0.6 -0.4 0 } Component<Object> { type sphere radius 0.6 } "
         "Component<Material> { index 2 } }\n"
         "Node { Transform { translate 1.4 -0.2 -2 } Component<Object> { type sphere radius 0.8 } "
         "Component<Material> { index 3 } }\n"
         "Node { Transform { translate -0.4 -0.6 0.6 } Component<Object> { type sphere radius 0.4 "
         "} "
         "Component<Material> { index 4 } }\n" +
         lights + " }";
}

const char* kLamps =
    "Node { Transform { translate -2 1.5 0 y_rotate 60 } "
    "Component<Object> { type rectangle width 1.5 height 1 } Component<Material> { index 0 } "
    "Component<Light> { type area radiance 6 6 6 } }\n"
    "Node { Transform { translate 2 1.2 0 } Component<Object> { type sphere radius 0.5 } "
    "Component<Material> { index 0 } Component<Light> { type area radiance 4 4 4 } }\n"
    "Node { Transform { translate 0 2.5 -1 x_rotate 90 } Component<Object> { type disk radius 0.7 "
    "} "
    "Component<Material> { index 0 } Component<Light> { type area radiance 5 5 5 } }\n"
    "Node { Component<Object> { type triangle vertex0 -2 0 -3 vertex1 2 0 -4 vertex2 0 2 -3.5 } "
    "Component<Material> { index 0 } "
    "Component<Light> { type area radiance 2 2 2 two_sided false } }\n";

/// Two means agree by 4.7 standard errors, of which each is at most three thousandths of it.
void ExpectSame(const Estimate& a, const Estimate& b, double strength = 3e-3) {
  const double error = std::sqrt(a.error * a.error + b.error * b.error);
  EXPECT_LE(std::abs(a.mean - b.mean), test::kLargestDeviate * error) << a.mean << " " << b.mean;
  EXPECT_LE(a.error, testing_support::LargestError(strength) * a.mean);
  EXPECT_LE(b.error, testing_support::LargestError(strength) * b.mean);
}

/// The mean of the whole picture, with its error from runs that do not depend on each other.
Estimate EstimatePicture(const Integrator& integrator, uint32_t samples) {
  // Any evenly spread points do; these are multiples of two irrational numbers.
  const auto point = [](uint32_t i) {
    const double x = i * 0.7548776662466927, y = i * 0.5698402909980532;
    return Vec2{static_cast<float>(2 * (x - std::floor(x)) - 1),
                static_cast<float>(2 * (y - std::floor(y)) - 1)};
  };
  return EstimateMean(integrator, point, 64, samples);
}

/// With a seed for each kind of technique, so that estimates do not depend on each other.
Estimate With(const Scene& scene, const PathTechniques& techniques, uint32_t samples = 8192,
              uint32_t bounces = 6) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.seed = 1 + (techniques.next_event ? 1 : 0) + (techniques.roulette ? 2 : 0) +
                 (techniques.weights == PathTechniques::Weights::kPowerHeuristic ? 4 : 0) +
                 (techniques.light_choice == LightChoice::kUniform ? 8 : 0);
  // Few samples see other points of the picture than twice as many, which is in no error.
  if (testing_support::kIsSanitized) samples = std::min(samples, 8192u);
  return EstimatePicture(PathIntegrator(scene, options, techniques), samples);
}

PathTechniques RaysAlone() {
  PathTechniques techniques;
  techniques.next_event = false;
  return techniques;
}

// P7
TEST(NextEventEstimation, OfSurfacesDoesNotChangeTheMean) {
  const auto scene = CompileText(StillLife("", kLamps));
  ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
}

// P7
TEST(NextEventEstimation, OfAnEnvironmentDoesNotChangeTheMean) {
  const auto scene = CompileText(
      StillLife("Background { environment assets/cubemap/sky/front.png scale 2 rotate 40 }\n", ""));
  ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
}

// P7
TEST(NextEventEstimation, OfACubeMapDoesNotChangeTheMean) {
  const auto scene =
      CompileText(StillLife("Background { cube_map assets/assignment4/tex/rotunda }\n", ""));
  ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
}

// P7
TEST(NextEventEstimation, OfASoftSunDoesNotChangeTheMean) {
  const auto scene = CompileText(StillLife(
      "", "Component<Light> { type directional direction -1 -1 -0.5 color 2 2 2 angle 60 }"));
  ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
}

// P7: a mesh that hides parts of itself.
TEST(NextEventEstimation, OfAMeshDoesNotChangeTheMean) {
  const auto scene = CompileText(
      StillLife("",
                "Node { Transform { translate -1 1.5 0 x_rotate 30 y_rotate 20 } "
                "Component<Object> { type mesh obj_file assets/assignment4/models/cube.obj } "
                "Component<Material> { index 0 } "
                "Component<Light> { type area radiance 3 3 3 } }"));
  ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
}

// P7: the kinds together: point lights cannot be found by rays, and have to be sampled in both.
TEST(NextEventEstimation, KeepsLightsThatOnlyItCanSee) {
  const auto scene = CompileText(StillLife(
      "Background { color 0.2 0.2 0.2 ambient_light 0 0 0 }\n",
      std::string(kLamps) + "Node { Transform { translate 0 2 2 } Component<Light> { type point "
                            "color 8 8 8 attenuation 1 } }"));
  ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
}

// P9
TEST(Weights, DoNotChangeTheMean) {
  const auto scene = CompileText(StillLife("", kLamps));
  PathTechniques balance;
  balance.weights = PathTechniques::Weights::kBalanceHeuristic;
  ExpectSame(With(*scene, {}), With(*scene, balance));
}

// P9
TEST(LightChoice, DoesNotChangeTheMean) {
  const auto scene = CompileText(StillLife("", kLamps));
  PathTechniques uniform;
  uniform.light_choice = LightChoice::kUniform;
  ExpectSame(With(*scene, {}), With(*scene, uniform));
}

/// The still life under so many lamps that a tree chooses them: round, flat and points, above all
/// surfaces.
std::string ManyLamps(int count) {
  std::string lamps;
  for (int i = 0; i < count; ++i) {
    const char* kind = i % 3 == 0   ? "Component<Object> { type sphere radius 0.03 } "
                       : i % 3 == 1 ? "Component<Object> { type rectangle width 0.1 height 0.1 } "
                                    : "";
    const std::string light =
        i % 3 == 2 ? fmt::format("type point color {0} {0} {0} attenuation 20", 1 + i % 7)
                   : fmt::format("type area radiance {0} {0} {0}", 2 * (1 + i % 7));
    lamps += fmt::format(
        "Node {{ Transform {{ translate {} {} {} x_rotate {} }} {} {} "
        "Component<Light> {{ {} }} }} ",
        i % 10 * 0.4 - 2, 0.9 + i % 4 * 0.4, i / 10 * 0.6 - 2, 30 * (i % 12), kind,
        i % 3 == 2 ? "" : "Component<Material> { index 0 }", light);
  }
  return lamps;
}

// P9: a wrong probability on either side of the weights, or a lamp that is left out, would show.
TEST(LightChoice, ByATreeDoesNotChangeTheMean) {
  const auto scene = CompileText(StillLife("", ManyLamps(60)));
  PathTechniques uniform;
  uniform.light_choice = LightChoice::kUniform;
  ExpectSame(With(*scene, {}), With(*scene, uniform, 32768), 6e-3);
}

// A step for each lamp with each other one would take much longer.
TEST(LightChoice, IsReadyInAShortTimeWithTenThousandLamps) {
  const auto start = std::chrono::steady_clock::now();
  const auto scene = CompileText(StillLife("", ManyLamps(10000)));
  const PathIntegrator integrator(*scene, {});
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_LT(time.count(), 20);
}

// P9
TEST(Roulette, DoesNotChangeTheMean) {
  const auto scene = CompileText(StillLife("", kLamps));
  PathTechniques none;
  none.roulette = false;
  ExpectSame(With(*scene, {}, 8192, 12), With(*scene, none, 8192, 12));
}

/// The still life and its lamps with everything, the camera included, moved and scaled.
std::unique_ptr<const Scene> Placed(Vec3 to, float scale) {
  const std::string scene = StillLife("", kLamps);
  const size_t materials = scene.find("Materials"), body = scene.find("Scene {") + 7;
  const Vec3 eye = to + Vec3{0, 1, 4} * scale;
  const auto text = fmt::format(
      "Camera {{ center {} {} {} direction 0 -0.2 -1 up 0 1 0 fov 60 }}\n{} "
      "Node {{ Transform {{ translate {} {} {} scale {} {} {} }} {} }}",
      eye.x, eye.y, eye.z, scene.substr(materials, body - materials), to.x, to.y, to.z, scale,
      scale, scale, scene.substr(body));
  return CompileText(text);
}

// P7: Radiance does not depend on where a scene is: neither do the ends of shadow rays, which have
// to stop before the lamp. The same with rays alone, since those know of no such ends.
TEST(NextEventEstimation, OfASceneFarAwayDoesNotChangeTheMean) {
  const auto expected = With(*Placed({0, 0, 0}, 1), {});
  const auto far = Placed({3000, -1000, 2000}, 1);
  ExpectSame(expected, With(*far, RaysAlone(), 16384));
  ExpectSame(With(*far, {}), With(*far, RaysAlone(), 16384));
}

// P7: what absorbs counts in lengths, so here both sides are of the same size.
TEST(NextEventEstimation, OfATinyOrHugeSceneDoesNotChangeTheMean) {
  for (const float scale : {1e-4f, 1e4f}) {
    const auto scene = Placed({scale, scale, scale}, scale);
    ExpectSame(With(*scene, {}), With(*scene, RaysAlone(), 16384));
  }
}

// On a floor under a small lamp the difference is what next-event estimation is for.
TEST(NextEventEstimation, TakesTheNoiseFromSmallLamps) {
  const auto scene = CompileText(
      kCamera +
      "Materials { Material { type diffuse albedo 0.7 0.7 0.7 } }\n"
      "Scene { Node { Component<Object> { type plane normal 0 1 0 offset -1 } "
      "Component<Material> { index 0 } }\n"
      "Node { Transform { translate 0 1 0 x_rotate 90 } "
      "Component<Object> { type rectangle width 0.2 height 0.2 } Component<Material> { index 0 } "
      "Component<Light> { type area radiance 50 50 50 } } }");
  constexpr uint32_t kSamples = testing_support::kIsSanitized ? 8192 : 1024;
  EXPECT_LT(With(*scene, {}, kSamples).error * 5, With(*scene, RaysAlone(), kSamples).error);
}

// Depth limits by kind.

double MeanOf(const std::string& scene_text, IntegratorOptions options, Vec2 where = {0, 0}) {
  const auto scene = CompileText(scene_text);
  options.seed = 4;
  return EstimateRadiance(PathIntegrator(*scene, options), where, 16, 64).mean;
}

/// A camera inside of a closed sphere that glows and reflects; all paths are diffuse.
const std::string kRoom =
    std::string(testing_support::kCamera) +
    "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } }\n"
    "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 }\n"
    "Component<Light> { type area radiance 0.5 0.5 0.5 } }";

// P12
TEST(DepthLimits, OfDiffuseBouncesCutTheSeries) {
  for (uint32_t n = 0; n <= 3; ++n) {
    IntegratorOptions options;
    options.diffuse_bounces = n;
    options.mirror_bounces = 0;
    EXPECT_NEAR(MeanOf(kRoom, options), 1 - std::pow(0.5, n + 1), 1e-6) << n;
  }
}

/// Two parallel mirrors of which one glows faintly: every bounce is a mirror's.
TEST(DepthLimits, OfMirrorBouncesLeaveTheOthersAlone) {
  const std::string mirrors =
      std::string(testing_support::kCamera) +
      "Materials { Material { type mirror } }\n"
      "Scene { Node { Component<Object> { type plane normal 0 0 1 offset -1 } "
      "Component<Material> { index 0 } Component<Light> { type area radiance 1 1 1 } }\n"
      "Node { Component<Object> { type plane normal 0 0 1 offset 1 } "
      "Component<Material> { index 0 } Component<Light> { type area radiance 1 1 1 } } }";
  IntegratorOptions one_bounce;
  one_bounce.bounces = 1;
  const double reflectance = MeanOf(mirrors, one_bounce) - 1;
  for (uint32_t n = 0; n <= 3; ++n) {
    IntegratorOptions options;
    options.mirror_bounces = n;
    double expected = 0;
    for (uint32_t i = 0; i <= n; ++i) expected += std::pow(reflectance, i);
    EXPECT_NEAR(MeanOf(mirrors, options), expected, 1e-5) << n;
    options.mirror_bounces = 9;
    options.bounces = n;
    EXPECT_NEAR(MeanOf(mirrors, options), expected, 1e-5) << n;
  }
}

TEST(DepthLimits, OfTransmissionKeepLightOutsideOfGlass) {
  const std::string glass =
      std::string(testing_support::kCamera) +
      "Background { color 1 1 1 ambient_light 0 0 0 }\n"
      "Materials { Material { type dielectric ior 1.5 } }\n"
      "Scene { Node { Transform { translate 0 0 -3 } Component<Object> { type sphere radius 1 } "
      "Component<Material> { index 0 } } }";
  IntegratorOptions options;
  EXPECT_NEAR(MeanOf(glass, options), 1, 1e-3);
  options.transmission_bounces = 0;  // The first surface reflects 4 percent.
  EXPECT_NEAR(MeanOf(glass, options), 0.04, 0.02);
  EXPECT_GT(MeanOf(glass, options), 0);
}

// Beer's law: straight through a ball of glass of diameter 2 that does not refract.
TEST(Absorption, FollowsBeersLaw) {
  const std::string ball =
      std::string(testing_support::kCamera) +
      "Background { color 1 1 1 ambient_light 0 0 0 }\n"
      "Materials { Material { type dielectric ior 1 absorption 0.35 0 0 } }\n"
      "Scene { Node { Transform { translate 0 0 -3 } Component<Object> { type sphere radius 1 } "
      "Component<Material> { index 0 } } }";
  EXPECT_NEAR(MeanOf(ball, {}), std::exp(-0.7), 1e-5);
}

}  // namespace
}  // namespace candela
