#include "integrators/path.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing::HasSubstr;
using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;
using testing_support::kCamera;

IntegratorOptions Bounces(std::optional<uint32_t> bounces) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.seed = 7;
  return options;
}

/// A closed room that emits and reflects: all paths are as long as they may be.
std::string Room(double emission, double albedo) {
  return fmt::format(
      "{}Materials {{ Material {{ type diffuse albedo {} {} {} }} }}\n"
      "Scene {{ Component<Object> {{ type sphere radius 1 }} Component<Material> {{ index 0 }}\n"
      "Component<Light> {{ type area radiance {} {} {} }} }}",
      kCamera, albedo, albedo, albedo, emission, emission, emission);
}

// P12, CF1: without roulette every path of depth n gives the same partial sum.
TEST(Path, NBouncesGiveThePartialSum) {
  const auto scene = CompileText(Room(0.5, 0.5));
  double sum = 0;
  for (uint32_t n = 0; n <= 4; ++n) {
    sum += 0.5 * std::pow(0.5, n);
    const PathIntegrator integrator(*scene, Bounces(n), {.roulette = false});
    const auto estimate = EstimateRadiance(integrator, {0, 0}, 2, 16);
    EXPECT_NEAR(estimate.mean, sum, 1e-6) << n;
    EXPECT_NEAR(estimate.error, 0, 1e-6) << n;
  }
}

// P12
TEST(Path, RouletteDoesNotChangeThePartialSumOfDeepPaths) {
  const auto scene = CompileText(Room(0.5, 0.5));
  for (const uint32_t n : {5u, 6u, 8u}) {
    ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces(n)), {0, 0}, 128, 1024),
                   1 - std::pow(0.5, n + 1));
  }
}

// P9: the brighter the walls, the more of the light is carried by paths that survived.
TEST(Path, RouletteDoesNotChangeTheMeanOfEndlessPaths) {
  for (const double albedo : {0.3, 0.7}) {
    const auto scene = CompileText(Room(1 - albedo, albedo));
    ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces({})), {0, 0}, 256, 1024), 1);
  }
}

TEST(Path, BounceZeroSeesWhatShinesAndNothingElse) {
  const auto scene = CompileText(Room(0.25, 0.5));
  EXPECT_EQ(EstimateRadiance(PathIntegrator(*scene, Bounces(0)), {0.3f, 0.1f}, 2, 4).mean, 0.25);
}

TEST(Path, CountsItsRays) {
  const auto scene = CompileText(Room(0.5, 0.5));
  const PathIntegrator integrator(*scene, Bounces(3), {.roulette = false});
  const auto workspace = integrator.MakeWorkspace();
  const SampleRequest requests[2] = {};
  Spectrum radiance[2];
  integrator.Trace(requests, workspace.get(), {radiance});
  EXPECT_EQ(workspace->rays.camera, 2u);
  EXPECT_EQ(workspace->rays.reflection, 6u);
  EXPECT_EQ(workspace->rays.shadow, 0u);
}

TEST(Path, RefusesMaterialsThatAreNotPhysical) {
  const auto scene = CompileText(std::string(kCamera) +
                                 "Materials { Material { diffuse 1 1 1 }\n"
                                 "Material { diffuse 0.5 0.5 0.5 specular 1 1 1 } } Scene {\n"
                                 "Component<Material> { index 1 } "
                                 "Component<Object> { type sphere radius 1 } }");
  const auto integrator = CreateIntegrator("path", *scene, {});
  ASSERT_FALSE(integrator.ok());
  EXPECT_EQ(integrator.error().code, ErrorCode::kInput);
  EXPECT_THAT(integrator.error().message,
              HasSubstr("scene:3:1: the material has a Phong highlight"));
}

/// A triangle in z = -2 whose shading normals lean 45 degrees towards +x.
class LeaningNormals : public testing::Test {
 protected:
  std::unique_ptr<const Scene> Compile(const std::string& background,
                                       const std::string& light = "") {
    testing_support::Put(folder_ / "leaning.obj",
                         "v -9 -9 -2\nv 9 -9 -2\nv 0 9 -2\nvn 1 0 1\nf 1//1 2//1 3//1\n");
    return CompileText(kCamera + background +
                           "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } }\n"
                           "Scene { Component<Object> { type mesh obj_file leaning.obj } "
                           "Component<Material> { index 0 } " +
                           light + " }",
                       folder_.path());
  }

  testing_support::TempFolder folder_;
};

TEST_F(LeaningNormals, DoNotLetALightBehindTheSurfaceThrough) {
  const auto scene =
      Compile("", "Component<Light> { type directional direction -1 0 0.1 color 1 1 1 }");
  ASSERT_EQ(scene->lights().size(), 1u);
  EXPECT_EQ(EstimateRadiance(PathIntegrator(*scene, Bounces(1)), {0, 0}, 2, 16).mean, 0.0);
}

// Of the directions around a normal that leans by phi, weighted with their cosine, the share
// (1 + cos phi) / 2 lies above the surface and sees the sky; the rest would come through it.
TEST_F(LeaningNormals, DoNotLetTheSkyBehindTheSurfaceThrough) {
  const auto scene = Compile("Background { color 1 1 1 ambient_light 0 0 0 }\n");
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces(1)), {0, 0}, 64, 1024),
                 0.5 * (1 + std::sqrt(0.5)) / 2);
}

}  // namespace
}  // namespace candela
