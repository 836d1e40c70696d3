// Bodies that touch or overlap: what a scene says fills them, and which of them has priority.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "integrators/medium_stack.h"
#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::Estimate;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;

/// A body of a medium behind a plane, sphere or other shape.
std::string Body(const std::string& object, const std::string& medium, int priority,
                 const char* surface = "clear", const char* transform = "") {
  return fmt::format(
      "Node {{ {} Component<Object> {{ type {} }} Component<Material> {{ name {} }} "
      "Component<Interior> {{ medium {} priority {} }} }}\n",
      transform, object, surface, medium, priority);
}

/// The camera in (0, 0, 5) looks along -z at a black wall in z = -3 of radiance `wall`.
std::string Before(const std::string& media, const std::string& bodies, double around,
                   double wall) {
  return fmt::format(
      "Camera {{ center 0 0 5 direction 0 0 -1 up 0 1 0 fov 90 }}\n"
      "Background {{ color {0} {0} {0} }}\n"
      "Media {{ {1} }}\n"
      "Materials {{ Material {{ name black type diffuse albedo 0 0 0 }}\n"
      "Material {{ name clear type dielectric }}\n"
      "Material {{ name frosted type dielectric roughness 0.6 }} }}\n"
      "Scene {{ Node {{ Component<Material> {{ name black }} Component<Object> {{ type plane "
      "normal 0 0 1 offset -3 }} Component<Light> {{ type area radiance {3} {3} {3} }} }}\n{2} }}",
      around, media, bodies, wall);
}

/// What lies between the planes z = top and z = bottom.
std::string Layer(double top, double bottom, const std::string& medium, int priority) {
  return Body(fmt::format("plane normal 0 0 1 offset {}", top), medium, priority) +
         Body(fmt::format("plane normal 0 0 -1 offset {}", -bottom), medium, priority);
}

Estimate Seen(const std::string& text, IntegratorOptions options = {}, uint32_t pixels = 256,
              uint32_t samples = 2048, Vec2 where = {0, 0}) {
  const auto scene = CompileText(text);
  options.seed = 3;
  return EstimateRadiance(PathIntegrator(*scene, options), where, pixels, samples);
}

constexpr double kWater = 1.333, kGlass = 1.5;
constexpr const char* kOnlyWater = "Medium { name water ior 1.333 }";

double HeadOn(double a, double b) {
  return std::pow((a - b) / (a + b), 2);
}

// The camera is in glass, which ends in z = 0; water of lower priority begins above that, in z =
// 0.5, where nothing is to be seen of it.
TEST(NestedMedia, GlassReflectsAgainstWaterAsTheirIndicesSay) {
  const auto text = [](double around, double wall) {
    return Before(kOnlyWater,
                  Body("plane normal 0 0 -1 offset 0", "glass", 2) +
                      Body("plane normal 0 0 1 offset 0.5", "water", 1),
                  around, wall);
  };
  const double r = HeadOn(kGlass, kWater);
  const Estimate reflected = Seen(text(1, 0), {}, 256, 8192);
  EXPECT_NEAR(reflected.mean, r, test::kLargestDeviate * reflected.error);
  EXPECT_LE(reflected.error, testing_support::LargestError(0.01) * r);
  ExpectEstimate(Seen(text(0, 1)), (1 - r) * std::pow(kGlass / kWater, 2));
}

// Of boundaries that absorb nothing R / T of the stack is the sum of those of the boundaries.
TEST(NestedMedia, WaterInAGlassIsTheSameOverlappingOrNot) {
  const auto share = [](double a, double b) { return HeadOn(a, b) / (1 - HeadOn(a, b)); };
  const double expected = 1 / (1 + share(1, kGlass) + share(kGlass, kWater) + share(kWater, 1));
  ExpectEstimate(
      Seen(Before(kOnlyWater, Layer(0, -1, "glass", 2) + Layer(-0.8, -2, "water", 1), 0, 1)),
      expected);
  // The same by the indices of materials over each other, each boundary once.
  const std::string exact = fmt::format(
      "Camera {{ center 0 0 5 direction 0 0 -1 up 0 1 0 fov 90 }}\n"
      "Materials {{ Material {{ name black type diffuse albedo 0 0 0 }}\n"
      "Material {{ name top type dielectric ior 1.5 }}\n"
      "Material {{ name between type dielectric ior {} }}\n"
      "Material {{ name water type dielectric ior 1.333 }} }}\n"
      "Scene {{ Node {{ Component<Material> {{ name black }} Component<Object> {{ type plane "
      "normal "
      "0 0 1 offset -3 }} Component<Light> {{ type area radiance 1 1 1 }} }}\n"
      "Node {{ Component<Object> {{ type plane normal 0 0 1 offset 0 }} Component<Material> {{ "
      "name "
      "top }} }}\n"
      "Node {{ Component<Object> {{ type plane normal 0 0 1 offset -1 }} Component<Material> {{ "
      "name "
      "between }} }}\n"
      "Node {{ Component<Object> {{ type plane normal 0 0 -1 offset 2 }} Component<Material> {{ "
      "name "
      "water }} }} }}",
      kWater / kGlass);
  ExpectEstimate(Seen(exact), expected);
}

// Media that do not refract, so that nothing is left to chance.
constexpr const char* kTinted =
    "Medium { name half ior 1 absorption 0.5 0 0 } Medium { name fifth ior 1 absorption 0.2 0 0 } "
    "Medium { name air }";

TEST(NestedMedia, TheGreatestPriorityAbsorbs) {
  const auto layers = [](int upper, int lower) {
    return Before(kTinted, Layer(0, -1, "half", upper) + Layer(-0.5, -2, "fifth", lower), 0, 1);
  };
  EXPECT_NEAR(Seen(layers(2, 1), {}, 2, 16).mean, std::exp(-0.5 - 0.2), 1e-5);
  EXPECT_NEAR(Seen(layers(1, 2), {}, 2, 16).mean, std::exp(-0.25 - 0.3), 1e-5);
}

TEST(NestedMedia, AHiddenSurfaceTakesNoBounce) {
  const std::string text =
      Before(kTinted, Layer(0, -1, "half", 2) + Layer(-0.5, -2, "fifth", 1), 0, 1);
  IntegratorOptions options;
  options.bounces = 3;  // Into the first, into the second, out of that.
  EXPECT_NEAR(Seen(text, options, 2, 16).mean, std::exp(-0.7), 1e-5);
  options.bounces = 2;
  EXPECT_EQ(Seen(text, options, 2, 16).mean, 0);
}

// Of bodies with the same priority the inner one counts.
TEST(NestedMedia, ABubbleTakesTheMediumAway) {
  const std::string text =
      Before(kTinted, Body("sphere radius 2", "half", 0) + Body("sphere radius 1", "air", 0), 0, 1);
  EXPECT_NEAR(Seen(text, {}, 2, 16).mean, std::exp(-0.5 * 2), 1e-5);
}

// The same medium again inside of what is inside of it has a surface of its own, both ways.
TEST(NestedMedia, ADropletInADropHasItsSurface) {
  const std::string text =
      Before(kTinted,
             Body("sphere radius 2", "half", 0) + Body("sphere radius 1", "fifth", 0) +
                 Body("sphere radius 0.5", "half", 0),
             0, 1);
  IntegratorOptions options;
  options.bounces = 6;
  ExpectEstimate(Seen(text, options), std::exp(-0.5 * 3 - 0.2 * 1));
  options.bounces = 5;
  EXPECT_EQ(Seen(text, options, 2, 16).mean, 0);
}

// Two spheres whose parts have the same interior are one body.
TEST(NestedMedia, PartsOfOneBodyHaveNoSurfaceBetweenThem) {
  const std::string text =
      Before(kTinted,
             Body("sphere radius 1", "half", 3) +
                 Body("sphere radius 1", "half", 3, "clear", "Transform { translate 0 0 1 }"),
             0, 1);
  IntegratorOptions options;
  options.bounces = 2;
  EXPECT_NEAR(Seen(text, options, 2, 16).mean, std::exp(-0.5 * 3), 1e-5);
}

TEST(NestedMedia, TheCameraMayBeInOne) {
  const std::string ball =
      Body("sphere radius 1.5", "half", 0, "clear", "Transform { translate 0 0 5 }");
  EXPECT_NEAR(Seen(Before(kTinted, ball, 0, 1), {}, 2, 16).mean, std::exp(-0.75), 1e-5);
  // Below the surface of a sea, seen along it.
  EXPECT_NEAR(
      Seen(Before(kTinted, Body("plane normal 0 1 0 offset 1", "fifth", 0), 0, 1), {}, 2, 16).mean,
      std::exp(-0.2 * 8), 1e-5);
  // In two parts of one body, which ends where the second of them does.
  const std::string parts =
      Body("sphere radius 1.5", "half", 0, "clear", "Transform { translate 0 0 4.5 }") +
      Body("sphere radius 1.5", "half", 0, "clear", "Transform { translate 0 0 5.5 }");
  EXPECT_NEAR(Seen(Before(kTinted, parts, 0, 1), {}, 2, 16).mean, std::exp(-0.5 * 2), 1e-5);
}

// One side of a body that is open is no body: nobody can tell what lies behind it.
TEST(NestedMedia, AnOpenPaneBehindTheCameraChangesNothing) {
  for (const char* place : {"translate 1.8 2.55 8.9", "translate 1.8 2.55 8.9 y_rotate 180"}) {
    const std::string pane = Body("rectangle width 4 height 4", "half", 0, "clear",
                                  fmt::format("Transform {{ {} }}", place).c_str());
    EXPECT_EQ(Seen(Before(kTinted, pane, 0, 1), {}, 2, 16).mean, 1) << place;
  }
}

// P4: what absorbs nothing is invisible where light comes from everywhere.
TEST(NestedMedia, ClearOnesAreInvisibleInTheFurnace) {
  for (const char* surface : {"clear", "frosted"}) {
    SCOPED_TRACE(surface);
    const std::string drink =
        "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 }\n"
        "Background { color 1 1 1 }\n"
        "Materials { Material { name clear type dielectric } "
        "Material { name frosted type dielectric roughness 0.6 } }\n"
        "Scene { " +
        Body("sphere radius 1.2", "glass", 2, surface) +
        Body("sphere radius 1", "water", 1, "clear", "Transform { translate 0.9 0 0 }") +
        Body("sphere radius 0.4", "diamond", 3, surface, "Transform { translate 0.8 0.2 0.5 }") +
        " }";
    const bool is_smooth = surface == std::string("clear");
    for (const Vec2 where : {Vec2{0, 0}, Vec2{0.4f, 0.1f}, Vec2{-0.3f, 0.2f}}) {
      const Estimate estimate = Seen(drink, {}, 64, is_smooth ? 256 : 1024, where);
      EXPECT_NEAR(estimate.mean, 1,
                  (is_smooth ? 1e-5 : 5e-3) + test::kLargestDeviate * estimate.error);
      EXPECT_LE(estimate.error, testing_support::LargestError(1e-2));
    }
  }
}

TEST(NestedMedia, MoreBodiesThanAreKeptTrackOfAreCounted) {
  const auto crowd = [](int count) {
    std::string media, bodies;
    for (int i = 0; i < count; ++i) {
      media += fmt::format("Medium {{ name m{} absorption 0.0{} 0 0 }} ", i, i + 1);
      bodies += Body(fmt::format("sphere radius {}", 3 - 0.2 * i), fmt::format("m{}", i), i);
    }
    const auto scene = CompileText(Before(media, bodies, 0, 1));
    const PathIntegrator path(*scene, {});
    const auto workspace = path.MakeWorkspace();
    const SampleRequest request{};
    Spectrum radiance;
    path.Trace({&request, 1}, workspace.get(), SampleOutput{{&radiance, 1}});
    return workspace->rays.crowded;
  };
  EXPECT_EQ(crowd(MediumStack::kMost), 0u);
  EXPECT_GT(crowd(MediumStack::kMost + 1), 0u);
}

// P17: nothing depends on the order of the bodies in the file.
TEST(NestedMedia, DoNotDependOnTheirOrder) {
  const std::vector<std::string> bodies = {Layer(0, -1, "half", 2), Layer(-0.5, -2, "fifth", 1),
                                           Layer(-0.2, -0.7, "air", 3)};
  const double expected = std::exp(-0.5 * 0.5 - 0.2 * 1);
  for (const auto& order : {std::vector<size_t>{0, 1, 2}, {2, 1, 0}, {1, 2, 0}}) {
    std::string text;
    for (const size_t i : order) text += bodies[i];
    ExpectEstimate(Seen(Before(kTinted, text, 0, 1)), expected);
  }
}

}  // namespace
}  // namespace candela
