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
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;
using testing_support::kCamera;

std::unique_ptr<const Scene> SceneOf(const std::string& text) {
  return CompileText(kCamera + text + " }");
}

/// The wall z = -2, seen head-on from the origin.
std::string Wall(const std::string& material, const std::string& background = "") {
  return "Background { " + background + " } Materials { Material { " + material +
         " } Material { diffuse 0 0 0 } Material { type diffuse albedo 0 0 0 } }\n"
         "Scene { Node { Component<Object> { type plane normal 0 0 1 offset -2 } "
         "Component<Material> { index 0 } }\n";
}

IntegratorOptions Bounces(uint32_t bounces) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.shadows = true;
  return options;
}

/// The radiance through one image point and the rays that it takes.
struct Seen {
  Rgb color;
  RayCounts rays;
};

Seen Trace(const Integrator& integrator, Vec2 image_point = {0, 0}) {
  const auto workspace = integrator.MakeWorkspace();
  SampleRequest request;
  request.image_point = image_point;
  Spectrum radiance;
  integrator.Trace({&request, 1}, workspace.get(), {{&radiance, 1}});
  return {radiance.ToRgb(), workspace->rays};
}

Seen Trace(const std::string& text, const IntegratorOptions& options, Vec2 image_point = {0, 0}) {
  const auto scene = SceneOf(text);
  const auto integrator = WhittedIntegrator::Create(*scene, options);
  return Trace(**integrator, image_point);
}

void ExpectColor(Rgb color, Rgb expected, float error = 2e-6f) {
  EXPECT_NEAR(color.x, expected.x, error);
  EXPECT_NEAR(color.y, expected.y, error);
  EXPECT_NEAR(color.z, expected.z, error);
}

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
  EXPECT_LE(a.error, 1e-3 * a.mean);
  EXPECT_LE(b.error, 1e-3 * b.mean);
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
  EXPECT_LE(seen.error, 1e-3 * seen.mean);
  EXPECT_LE(expected.error, 3e-3 * expected.mean);
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
}  // namespace candela
