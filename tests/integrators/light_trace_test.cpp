// What is special to light tracing; that it sees the light of path tracing is for
// same_light_test.cpp.

#include "integrators/light_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "integrators/registry.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing::HasSubstr;
using testing_support::CompileText;

std::string MessageFor(const std::string& text) {
  const auto scene = CompileText(testing_support::kCamera + text);
  const auto created = CreateIntegrator("light_trace", *scene, {});
  return created.ok() ? "" : created.error().message;
}

const std::string kGrey = "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } }\n";

std::string Floor(const std::string& more = "") {
  return "Node { Component<Object> { type plane normal 0 1 0 offset -1 } Component<Material> { "
         "index 0 } " +
         more + " }\n";
}

TEST(LightTraceCreate, RefusesLampsThatCannotBeSampled) {
  const std::string lamp = "Component<Light> { type area radiance 1 1 1 }";
  EXPECT_THAT(MessageFor(kGrey + "Scene { " + Floor(lamp) + " }"),
              HasSubstr("the plane is a lamp whose surface cannot be sampled"));
  const std::string black = "Component<Light> { type area radiance 0 0 0 }";
  EXPECT_EQ(MessageFor(kGrey + "Scene { " + Floor(black) + " }"), "");
}

// A disk across the sky light covers what is finite.
TEST(LightTraceCreate, RefusesEndlessSurfacesUnderASky) {
  const char* skies[] = {
      "Background { color 1 1 1 ambient_light 0 0 0 }\n",
      "Background { environment assets/environments/sky.hdr }\n",
      "Background { cube_map assets/assignment4/tex/rotunda }\n",
  };
  for (const char* sky : skies) {
    EXPECT_THAT(MessageFor(sky + kGrey + "Scene { " + Floor() + " }"), HasSubstr("has no end"));
  }
  const std::string sun = "Component<Light> { type directional direction 0 -1 0 color 1 1 1 }";
  EXPECT_THAT(MessageFor(kGrey + "Scene { " + Floor() + sun + " }"), HasSubstr("has no end"));
  const std::string point = "Component<Light> { type point color 1 1 1 attenuation 1 }";
  EXPECT_EQ(MessageFor(kGrey + "Scene { " + Floor() + point + " }"), "");
}

TEST(LightTraceCreate, RefusesAFalloffThatLightDoesNotHave) {
  const auto lamp = [](const char* falloff) {
    return kGrey + "Scene { Component<Light> { type point falloff " + falloff + " } }";
  };
  EXPECT_THAT(MessageFor(lamp("1 0 1")),
              HasSubstr("no light that is sent out falls off like this"));
  EXPECT_EQ(MessageFor(lamp("0 0 1")), "");
}

// Which of two bodies fills the place that they share must not depend on where light comes from.
TEST(LightTraceCreate, RefusesBodiesThatMayOverlapWithTheSamePriority) {
  const auto scene = [](const char* first, const char* second, const char* place) {
    return std::string(
               "Materials { Material { name glass type dielectric ior 1.5 }\n"
               "Material { name amber type dielectric ior 1.5 absorption 0 1 2 } }\n"
               "Media { Medium { name tea ior 1.3 } }\nScene {\n"
               "Node { Component<Object> { type sphere radius 1 } ") +
           first + "}\nNode { Transform { translate " + place +
           " } Component<Object> { type sphere radius 1 } " + second + "} }";
  };
  const char* glass = "Component<Material> { name glass }";
  const char* amber = "Component<Material> { name amber }";
  const char* tea = "Component<Material> { name glass } Component<Interior> { medium tea }";
  const char* more =
      "Component<Material> { name glass } Component<Interior> { medium tea priority 1 }";
  EXPECT_THAT(MessageFor(scene(glass, tea, "1 1 1")),
              HasSubstr("the sphere and the sphere at scene:6:33 may overlap and have the same "
                        "priority"));
  EXPECT_THAT(MessageFor(scene(glass, tea, "1 1 1")), testing::StartsWith("scene:7:63: "));
  EXPECT_NE(MessageFor(scene(tea, glass, "1 1 1")), "");
  EXPECT_NE(MessageFor(scene(amber, glass, "1 1 1")), "");
  EXPECT_EQ(MessageFor(scene(glass, tea, "0 0 2.5")), "");
  EXPECT_EQ(MessageFor(scene(glass, more, "1 1 1")), "");
  EXPECT_EQ(MessageFor(scene(tea, tea, "1 1 1")), "");
  EXPECT_EQ(MessageFor(scene(glass, glass, "1 1 1")), "");
}

// Where they are at any time counts, not where they begin.
TEST(LightTraceCreate, RefusesBodiesThatComeToOverlap) {
  const auto scene = [](const char* end) {
    return std::string(
               "Materials { Material { name glass type dielectric ior 1.5 } }\n"
               "Media { Medium { name tea ior 1.3 } }\nScene {\n"
               "Node { Component<Object> { type sphere radius 1 } Component<Material> { name glass "
               "} "
               "}\nNode { Keyframes { Transform { translate -9 0 0 } Transform { translate ") +
           end +
           " } } Component<Object> { type sphere radius 1 } Component<Material> { name glass } "
           "Component<Interior> { medium tea } } }";
  };
  EXPECT_THAT(MessageFor(scene("-0.5 0 0")), HasSubstr("may overlap and have the same priority"));
  EXPECT_EQ(MessageFor(scene("-5 0 0")), "");
}

// Each of the three meets the others; of a pair the later one is told.
TEST(LightTraceCheck, ReportsEachBodyAndEachLampOnce) {
  std::string nodes;
  for (const char* priority : {"1", "2", "3"}) {
    nodes += std::string("Node { Component<Object> { type sphere radius ") + priority +
             " } Component<Material> { name glass } Component<Interior> { medium m" + priority +
             " } }\n";
  }
  const std::string lamp = "Component<Light> { type area radiance 1 1 1 }";
  const auto scene = CompileText(
      std::string(testing_support::kCamera) +
      "Materials { Material { type diffuse } Material { name glass type dielectric } }\n"
      "Media { Medium { name m1 ior 1.1 } Medium { name m2 ior 1.2 } Medium { name m3 ior 1.3 } }\n"
      "Scene {\n" +
      nodes + Floor(lamp) + Floor(lamp) + "}");
  Diagnostics found;
  CheckForIntegrator("light_trace", *scene, &found);
  ASSERT_EQ(found.ErrorCount(), 4u);
  const auto lines = found.Lines();
  EXPECT_THAT(lines[0], testing::StartsWith("scene:6:"));
  EXPECT_THAT(lines[1], testing::StartsWith("scene:7:"));
  EXPECT_THAT(lines[2], testing::StartsWith("scene:8:"));
  EXPECT_THAT(lines[3], testing::StartsWith("scene:9:"));
}

TEST(LightTraceCreate, RefusesMaterialsThatAreNotPhysical) {
  EXPECT_THAT(MessageFor("Materials { Material { type phong diffuse 1 1 1 specular 1 1 1 } } "
                         "Scene { Component<Material> { index 0 } "
                         "Component<Object> { type sphere radius 1 } }"),
              HasSubstr("the integrator 'light_trace' does not know"));
}

std::string LitFloor(const std::string& light) {
  return testing_support::kCamera + kGrey +
         "Scene { Node { Transform { translate 0 -1 -2 x_rotate -90 } Component<Object> { type "
         "rectangle width 2 height 2 } Component<Material> { index 0 } }\n" +
         light + " }";
}

std::vector<Splat> SplatsOf(const Integrator& integrator, uint64_t first, uint64_t count) {
  std::vector<Splat> splats;
  const auto workspace = integrator.MakeWorkspace();
  integrator.TraceLightPaths(first, count, workspace.get(), &splats);
  return splats;
}

const char* kPoint =
    "Node { Transform { translate 0 1 -2 } Component<Light> { type point attenuation 1 } }";

TEST(LightTrace, WithoutLightHasNoLightPaths) {
  const auto dark = CompileText(LitFloor(""));
  EXPECT_FALSE(LightTraceIntegrator(*dark, {}).TracesLightPaths());
  EXPECT_TRUE(SplatsOf(LightTraceIntegrator(*dark, {}), 0, 1000).empty());
  const auto lit = CompileText(LitFloor(kPoint));
  EXPECT_TRUE(LightTraceIntegrator(*lit, {}).TracesLightPaths());
  EXPECT_FALSE(SplatsOf(LightTraceIntegrator(*lit, {}), 0, 1000).empty());
}

// A hole is no bounce: behind a screen that is almost nothing, one bounce still lights the floor.
TEST(LightTrace, HolesTakeNoBounce) {
  const std::string screen =
      "Node { Transform { translate 0 0.5 -2 x_rotate 90 } Component<Object> { type rectangle "
      "width "
      "9 height 9 } Component<Material> { index 1 } }\n";
  const std::string materials =
      "Materials { Material { name grey type diffuse albedo 0.5 0.5 0.5 }\n"
      "Material { type mask material grey opacity 0 } }\n";
  const auto scene = CompileText(
      testing_support::kCamera + materials +
      "Scene { Node { Transform { translate 0 -1 -2 x_rotate -90 } Component<Object> { type "
      "rectangle width 2 height 2 } Component<Material> { index 0 } }\n" +
      screen + kPoint + " }");
  IntegratorOptions one;
  one.bounces = 1;
  EXPECT_FALSE(SplatsOf(LightTraceIntegrator(*scene, one), 0, 1000).empty());
  one.bounces = 0;
  EXPECT_TRUE(SplatsOf(LightTraceIntegrator(*scene, one), 0, 1000).empty());
}

// The surface that light meets first is one bounce; without bounces nothing comes from there.
TEST(LightTrace, CountsBouncesAsPathTracingDoes) {
  const auto scene = CompileText(LitFloor(kPoint));
  IntegratorOptions none;
  none.bounces = 0;
  EXPECT_TRUE(SplatsOf(LightTraceIntegrator(*scene, none), 0, 1000).empty());
  IntegratorOptions one;
  one.bounces = 1;
  EXPECT_FALSE(SplatsOf(LightTraceIntegrator(*scene, one), 0, 1000).empty());
  one.diffuse_bounces = 0;
  EXPECT_TRUE(SplatsOf(LightTraceIntegrator(*scene, one), 0, 1000).empty());
}

bool AreSame(const std::vector<Splat>& a, const std::vector<Splat>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](auto& x, auto& y) {
           return x.image_point == y.image_point && x.radiance == y.radiance;
         });
}

TEST(LightTrace, APathDependsOnItsNumberAlone) {
  const auto scene = CompileText(LitFloor(kPoint));
  const LightTraceIntegrator integrator(*scene, {});
  for (const uint64_t first : {uint64_t{0}, (uint64_t{1} << 32) - 200}) {
    const std::vector<Splat> together = SplatsOf(integrator, first, 400);
    std::vector<Splat> one_by_one;
    for (uint64_t i = 0; i < 400; ++i) {
      const std::vector<Splat> one = SplatsOf(integrator, first + i, 1);
      one_by_one.insert(one_by_one.end(), one.begin(), one.end());
    }
    // Bounces come one after the other; the floor alone gives each path one at most.
    EXPECT_TRUE(AreSame(together, one_by_one));
    EXPECT_FALSE(together.empty());
  }
  EXPECT_FALSE(AreSame(SplatsOf(integrator, 0, 400), SplatsOf(integrator, uint64_t{1} << 32, 400)));
}

// What the camera's rays see themselves: a lamp and the sky, but not what they light.
TEST(LightTrace, TraceGivesWhatLightPathsCannotBring) {
  const auto scene = CompileText(
      std::string(testing_support::kCamera) +
      "Background { color 0.25 0.5 1 ambient_light 0 0 0 }\n" + kGrey +
      "Scene { Node { Transform { translate 0 0 -3 } Component<Object> { type sphere radius 0.5 } "
      "Component<Material> { index 0 } Component<Light> { type area radiance 3 2 1 } }\n"
      "Node { Transform { translate 1.5 0 -3 } Component<Object> { type sphere radius 0.5 } "
      "Component<Material> { index 0 } } }");
  const LightTraceIntegrator integrator(*scene, {});
  const auto workspace = integrator.MakeWorkspace();
  const SampleRequest requests[] = {{0, 0, 0, {0, 0}}, {0, 0, 1, {0.5f, 0}}, {0, 0, 2, {0, 0.9f}}};
  Spectrum radiance[3];
  integrator.Trace(requests, workspace.get(), SampleOutput{radiance});
  EXPECT_EQ(radiance[0].ToRgb(), (Rgb{3, 2, 1}));
  EXPECT_EQ(radiance[1].ToRgb(), Rgb());
  EXPECT_EQ(radiance[2].ToRgb(), (Rgb{0.25f, 0.5f, 1}));
}

}  // namespace
}  // namespace candela
