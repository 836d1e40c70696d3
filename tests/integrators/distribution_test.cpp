#include "integrators/distribution.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "integrators/distribution_draws.h"
#include "integrators/path.h"
#include "integrators/whitted.h"
#include "math/elementary.h"
#include "tests/integrators/one_ray.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela::test {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;

bool IsPlain(const std::string& text, const IntegratorOptions& options) {
  const auto scene = SceneOf(text);
  const auto made = WhittedIntegrator::Create(*scene, options);
  return dynamic_cast<const WhittedIntegrator*>(made->get()) != nullptr;
}

TEST(Distribution, IsWhatSceneAndOptionsAskFor) {
  EXPECT_TRUE(IsPlain(Wall("diffuse 1 1 1 specular 1 1 1"), Bounces(4)));
  IntegratorOptions options = Bounces(4);
  options.light_samples = 4;
  options.depth_of_field = true;
  options.indirect_samples = 0;
  EXPECT_TRUE(IsPlain(Wall("diffuse 1 1 1"), options)) << "neither lamps nor a lens";
  options.indirect_samples = 1;
  EXPECT_FALSE(IsPlain(Wall("diffuse 1 1 1"), options));
  EXPECT_FALSE(IsPlain(Wall("transmittance 1 1 1"), Bounces(4)));
  EXPECT_FALSE(IsPlain(Wall("reflection_roughness 0.1"), Bounces(4)));
  EXPECT_TRUE(IsPlain(Wall("reflection_roughness 0"), Bounces(4)));
  EXPECT_FALSE(IsPlain(Wall("diffuse 1 1 1", "fog homogeneous fog_density 1"), Bounces(4)));
}

TEST(Glossy, WithoutRoughnessIsTheMirror) {
  const std::string rest =
      "Background { color 0.5 1 0.25 ambient_light 0.1 0.2 0.3 } Materials { Material { diffuse "
      "0.1 0.1 0.1 specular 0.5 0.6 0.7 shininess 9 @ } } Scene { Node { Transform { translate "
      "0 0 -3 } Component<Object> { type sphere radius 1 } Component<Material> { index 0 } } "
      "Node { Component<Light> { type point } } Node { Component<Object> { type plane normal "
      "0 1 0 offset -2 } Component<Material> { index 0 } }";
  const auto with = [&](const std::string& more) {
    std::string text = rest;
    return SceneOf(text.replace(text.find('@'), 1, more));
  };
  const auto plain = with(""), sharp = with("reflection_roughness 0"),
             nearly = with("reflection_roughness 0.001");
  for (const Vec2 point : {Vec2{0.05f, 0.1f}, {0.1f, -0.2f}, {0.3f, 0.1f}, {0.5f, -0.6f}}) {
    const Rgb mirror = Trace(WhittedIntegrator(*plain, 4, true), point).color;
    EXPECT_EQ(Trace(DistributionIntegrator(*sharp, Bounces(4)), point).color, mirror);
    ExpectColor(Trace(DistributionIntegrator(*nearly, Bounces(4)), point).color, mirror, 2e-3f);
  }
}

// No light is lost, however flat the view.
TEST(Glossy, UnderAnEvenSkyReflectsItsSpecularColour) {
  for (const char* roughness : {"0.1", "0.5", "1"}) {
    const auto scene = SceneOf(
        fmt::format("Background {{ color 1 1 1 }} Materials {{ Material {{ diffuse 0 0 0 specular "
                    "0.5 0.25 1 reflection_roughness {} }} }} Scene {{ Node {{ Component<Object> "
                    "{{ type plane normal 0 1 0 offset -1 }} Component<Material> {{ index 0 }} }}",
                    roughness));
    const DistributionIntegrator integrator(*scene, Bounces(1));
    for (const float y : {-0.9f, -0.02f}) {
      const Seen seen = Trace(integrator, {0, y});
      ExpectColor(seen.color, {0.5f, 0.25f, 1});
      EXPECT_EQ(seen.rays.reflection, DistributionIntegrator::kUsualGlossySamples);
    }
  }
}

// A power n of the cosine has the mean cosine (n + 1) / (n + 2); here n = 1 / (2 r^4).
TEST(Glossy, SpreadsByThePowerOfItsRoughness) {
  const Vec3 axis = Normalize(Vec3{0.3f, -0.5f, 0.7f});
  for (const double roughness : {0.3, 0.6, 1.0}) {
    constexpr int kSide = 400;
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vec2 u{(static_cast<float>(i % kSide) + 0.5f) / kSide,
                   (static_cast<float>(i / kSide) + 0.5f) / kSide};
      sum += static_cast<double>(Dot(axis, SampleAbout(axis, static_cast<float>(roughness), u)));
    }
    const double n = 0.5 / std::pow(roughness, 4);
    EXPECT_NEAR(sum / (kSide * kSide), (n + 1) / (n + 2), 1e-4) << roughness;
  }
}

constexpr const char* kEvenSky = "color 1 0.5 0.25";

TEST(Gathering, UnderAnEvenSkyIsAlbedoTimesRadiance) {
  IntegratorOptions options;
  options.indirect_samples = 64;
  ExpectColor(Trace(Wall("diffuse 0.5 0.5 1", kEvenSky), options).color, {0.5f, 0.25f, 0.25f});
  // The cosine of 64 uniform directions is a noisy mean.
  options.indirect_sampling = IndirectSampling::kUniform;
  const auto scene = SceneOf(Wall("diffuse 0.5 0.5 1", kEvenSky));
  ExpectEstimate(EstimateRadiance(DistributionIntegrator(*scene, options), {0, 0}, 64, 64), 0.5);
}

TEST(Gathering, TakesThePlaceOfTheAmbientLight) {
  IntegratorOptions options;
  options.indirect_samples = 4;
  const std::string background = "color 0.5 0.5 0.5 ambient_light 1 1 1";
  ExpectColor(Trace(Wall("diffuse 0.5 0.5 0.5", background), options).color, {0.25f, 0.25f, 0.25f});
  EXPECT_EQ(Trace(Wall("diffuse 0.5 0.5 0.5", background), options).rays.reflection, 4u);
  EXPECT_EQ(Trace(Wall("specular 0 0 0 diffuse 0 0 0", background), options).rays.reflection, 0u);
}

/// A ball that shines beside two walls that meet: what is gathered comes from all of it.
std::unique_ptr<const Scene> Corner(const std::string& sky) {
  return SceneOf(
      "Background { color " + sky +
      " } Materials { Material { diffuse 0.5 0.5 0.5 } "
      "Material { diffuse 0.8 0.4 0.2 } Material { diffuse 0 0 0 } } Scene { "
      "Node { Component<Object> { type plane normal 0 0 1 offset -2 } Component<Material> "
      "{ index 0 } } Node { Component<Object> { type plane normal 1 0 0 offset -0.5 } "
      "Component<Material> { index 1 } } Node { Transform { translate 0.7 0.3 -1.2 } "
      "Component<Object> { type sphere radius 0.3 } Component<Material> { index 2 } "
      "Component<Light> { type area radiance 4 4 4 } }");
}

IntegratorOptions Gathering(uint32_t rays, IndirectSampling sampling, uint32_t light_samples = 0) {
  IntegratorOptions options;
  options.shadows = true;
  options.indirect_samples = rays;
  options.indirect_sampling = sampling;
  options.light_samples = light_samples;
  return options;
}

/// Two estimates of the same, each to 0.1 percent.
void ExpectSame(const testing_support::Estimate& a, const testing_support::Estimate& b) {
  EXPECT_LE(a.error, testing_support::LargestError(1e-3) * a.mean);
  EXPECT_LE(b.error, testing_support::LargestError(1e-3) * b.mean);
  EXPECT_NEAR(a.mean, b.mean, test::kLargestDeviate * std::hypot(a.error, b.error));
}

TEST(Gathering, GivesTheSamePictureByBothWaysToDraw) {
  const auto scene = Corner("0.6 0.6 0.6");
  const DistributionIntegrator by_cosine(*scene, Gathering(64, IndirectSampling::kCosine)),
      uniform(*scene, Gathering(64, IndirectSampling::kUniform));
  ExpectSame(EstimateRadiance(by_cosine, {0.1f, 0.05f}, 64, 256),
             EstimateRadiance(uniform, {0.1f, 0.05f}, 64, 256));
}

// What shines is counted once, whether it is sampled or found: without a sky the light is that of
// paths of two bounces.
TEST(Gathering, WithLampsThatAreSampledIsTheLightOfTwoBounces) {
  const auto scene = Corner("0 0 0");
  const DistributionIntegrator gathers(*scene, Gathering(16, IndirectSampling::kCosine, 4));
  ExpectSame(EstimateRadiance(gathers, {0.1f, 0.05f}, 64, 512),
             EstimateRadiance(PathIntegrator(*scene, Bounces(2)), {0.1f, 0.05f}, 64, 4096));
}

/// A lamp over the wall, with nothing else that shines.
std::string UnderALamp(const std::string& between) {
  return Wall("diffuse 0.8 0.8 0.8", "color 0 0 0") +
         "Node { Transform { translate 0 0.5 -1 } Component<Object> { type rectangle width 1 "
         "height 0.5 } Component<Material> { index 1 } Component<Light> { type area radiance 3 3 3 "
         "} }" +
         between;
}

TEST(AreaLight, LightsAsPathsSay) {
  const auto scene = SceneOf(UnderALamp(
      "Node { Transform { translate 0.1 0.2 -1.5 } Component<Object> { type disk radius 0.2 } "
      "Component<Material> { index 1 } }"));
  const auto expected =
      EstimateRadiance(PathIntegrator(*scene, Bounces(1)), {0.1f, -0.1f}, 64, 256);
  IntegratorOptions options;
  options.shadows = true;
  options.light_samples = 16;
  const auto seen =
      EstimateRadiance(DistributionIntegrator(*scene, options), {0.1f, -0.1f}, 64, 256);
  EXPECT_LE(seen.error, testing_support::LargestError(1e-3) * seen.mean);
  EXPECT_LE(expected.error, testing_support::LargestError(3e-3) * expected.mean);
  EXPECT_NEAR(seen.mean, expected.mean,
              test::kLargestDeviate * std::hypot(seen.error, expected.error));
}

TEST(AreaLight, TakesTheRaysThatAreAskedFor) {
  IntegratorOptions options;
  options.light_samples = 32;
  EXPECT_EQ(Trace(UnderALamp(""), options).rays.shadow, 0u);
  options.shadows = true;
  EXPECT_EQ(Trace(UnderALamp(""), options).rays.shadow, 32u);
  options.light_samples = 0;
  EXPECT_EQ(Trace(UnderALamp(""), options).rays.shadow, 0u);
  EXPECT_EQ(Trace(UnderALamp(""), options).color, Rgb());
}

/// The share of the light of a lamp 1 wide, 3 over the floor, that an edge 2 below the lamp leaves
/// at `x`. The camera looks down from below the edge.
double LeftBesideAnEdge(double x) {
  const auto light_at = [x](const std::string& edge) {
    const auto scene = CompileText(
        "Camera { center 0 0 -1.5 direction 0 0 -1 up 0 1 0 fov 90 } Materials { Material { "
        "diffuse 1 1 1 } Material { diffuse 0 0 0 } } Scene { Node { Component<Object> { type "
        "plane normal 0 0 1 offset -2 } Component<Material> { index 0 } } Node { Transform { "
        "translate 0 0 1 } Component<Object> { type rectangle width 1 height 0.01 } "
        "Component<Material> { index 1 } Component<Light> { type area radiance 9 9 9 } } " +
        edge + "}");
    IntegratorOptions options;
    options.shadows = true;
    options.light_samples = 4096;
    const Vec2 point{static_cast<float>(x / 0.5), 0};
    return static_cast<double>(Trace(DistributionIntegrator(*scene, options), point).color.x);
  };
  return light_at(
             "Node { Transform { translate -50 0 -1 } Component<Object> { type rectangle width 100 "
             "height 100 } Component<Material> { index 1 } }") /
         light_at("");
}

// CF35: the penumbra of a straight edge is s b / a = 0.5 wide, and half of the light is left in its
// middle. Across it the light grows nearly evenly, by the narrow lamp's cosines.
TEST(AreaLight, ThrowsThePenumbraOfTheClosedForm) {
  EXPECT_EQ(LeftBesideAnEdge(-0.251), 0);
  EXPECT_GT(LeftBesideAnEdge(-0.245), 0);
  EXPECT_NEAR(LeftBesideAnEdge(-0.125), 0.25, 0.01);
  EXPECT_NEAR(LeftBesideAnEdge(0), 0.5, 0.002);
  EXPECT_NEAR(LeftBesideAnEdge(0.125), 0.75, 0.01);
  EXPECT_LT(LeftBesideAnEdge(0.245), 1);
  EXPECT_EQ(LeftBesideAnEdge(0.251), 1);
}

}  // namespace
}  // namespace candela::test
