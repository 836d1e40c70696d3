#include "integrators/whitted.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::kCamera;

/// What a ray sees, and how many rays that took.
struct Seen {
  Rgb color;
  RayCounts rays;
};

// The camera stands in the origin and looks at the wall z = -2, whose normal is +z: there P is
// (0, 0, -2), and the mirrored view R points back to the camera.
std::string Wall(const std::string& material) {
  return "Materials { Material { " + material +
         " } Material { diffuse 0 0 0 } }\n"
         "Scene { Node { Component<Object> { type plane normal 0 0 1 offset -2 } "
         "Component<Material> { index 0 } }\n";
}

/// Something black in the way.
std::string Blocker(float z) {
  return fmt::format(
      "Node {{ Component<Object> {{ type plane normal 0 0 1 offset {:.9g} }} "
      "Component<Material> {{ index 1 }} }}\n",
      z);
}

std::string Light(const std::string& text, const std::string& transform = "") {
  return "Node { Transform { " + transform + " } Component<Light> { " + text + " } }\n";
}

std::string FromTheFront() {
  return Light("type directional direction 0 0 -1 color 1 0.5 0.25");
}

Seen Trace(const std::string& text, uint32_t bounces = 0, bool shadows = false) {
  const auto scene = CompileText(kCamera + text + " }");
  if (!scene) return {};
  const WhittedIntegrator integrator(*scene, bounces, shadows);
  const auto workspace = integrator.MakeWorkspace();
  const SampleRequest straight_ahead;
  Spectrum radiance;
  integrator.Trace({&straight_ahead, 1}, workspace.get(), {{&radiance, 1}});
  return {radiance.ToRgb(), workspace->rays};
}

void ExpectColor(const Seen& seen, Rgb expected) {
  EXPECT_NEAR(seen.color.x, expected.x, 2e-6);
  EXPECT_NEAR(seen.color.y, expected.y, 2e-6);
  EXPECT_NEAR(seen.color.z, expected.z, 2e-6);
}

TEST(Whitted, AMissSeesTheBackground) {
  const Seen seen = Trace("Background { color 0.25 0.5 0.75 ambient_light 1 1 1 } Scene {");
  EXPECT_EQ(seen.color, (Rgb{0.25f, 0.5f, 0.75f}));
  EXPECT_EQ(seen.rays.Total(), 1u);
}

TEST(WhittedDiffuse, IsCosineTimesIntensityTimesColour) {
  ExpectColor(Trace(Wall("diffuse 1 0.5 0.5") + FromTheFront()), {1, 0.25f, 0.125f});
  // From the side: the cosine is 3/5.
  ExpectColor(
      Trace(Wall("diffuse 1 0.5 0.25") + Light("type directional direction 0 -4 -3 color 1 1 1")),
      {0.6f, 0.3f, 0.15f});
}

TEST(WhittedDiffuse, LightFromBehindAddsNothing) {
  ExpectColor(Trace(Wall("diffuse 1 1 1") + Light("type directional direction 0 0 1 color 1 1 1")),
              {0, 0, 0});
}

TEST(WhittedDiffuse, LightsAdd) {
  ExpectColor(Trace(Wall("diffuse 1 1 1") + FromTheFront() + FromTheFront() +
                    Light("type point color 8 0 0 attenuation 4")),
              {2.5f, 1, 0.5f});
}

TEST(WhittedAmbient, IsAddedOnceWhateverTheLights) {
  const std::string background = "Background { color 0 0 0 ambient_light 0.5 0.25 1 }";
  ExpectColor(Trace(background + Wall("diffuse 0.5 1 0.25")), {0.25f, 0.25f, 0.25f});
  ExpectColor(Trace(background + Wall("diffuse 0.5 1 0.25") + FromTheFront() + FromTheFront()),
              {1.25f, 1.25f, 0.375f});
}

TEST(WhittedAmbient, IsZeroWithoutADiffuseColour) {
  ExpectColor(Trace("Background { color 0 0 0 ambient_light 1 1 1 }" + Wall("specular 0 0 0")),
              {0, 0, 0});
}

TEST(WhittedAmbient, IsNotShadowed) {
  ExpectColor(Trace("Background { color 0 0 0 ambient_light 0.5 0.5 0.5 }" + Wall("diffuse 1 1 1") +
                        FromTheFront() + Blocker(7),
                    0, true),
              {0.5f, 0.5f, 0.5f});
}

TEST(WhittedSpecular, IsTheCosineOfTheMirroredViewToThePowerOfTheShininess) {
  const std::string from_the_side = Light("type directional direction 0 -4 -3 color 1 1 1");
  ExpectColor(Trace(Wall("diffuse 0 0 0 specular 1 0.5 0 shininess 1") + from_the_side),
              {0.6f, 0.3f, 0});
  ExpectColor(Trace(Wall("diffuse 0 0 0 specular 1 0.5 0 shininess 2") + from_the_side),
              {0.36f, 0.18f, 0});
  ExpectColor(Trace(Wall("diffuse 0 0 0 specular 1 0.5 0 shininess 0.5") + from_the_side),
              {0.7745967f, 0.38729835f, 0});
}

TEST(WhittedSpecular, IsZeroBesideTheHighlight) {
  ExpectColor(Trace(Wall("diffuse 0 0 0 specular 1 1 1 shininess 1") +
                    Light("type directional direction 0 0 1 color 1 1 1")),
              {0, 0, 0});
}

// 0 to the power of 0 is 1, and there is no test of the side.
TEST(WhittedSpecular, WithShininessZeroItIsAddedEverywhereTheFarSideIncluded) {
  for (const std::string direction : {"0 0 -1", "0 -1 0", "0 0 1"}) {
    ExpectColor(Trace(Wall("diffuse 0 0 0 specular 0.5 0.25 1 shininess 0") +
                      Light("type directional direction " + direction + " color 1 1 1")),
                {0.5f, 0.25f, 1});
  }
}

TEST(WhittedShadow, IsCastOnlyWhenAskedFor) {
  const std::string text = Wall("diffuse 1 1 1") + FromTheFront() + Blocker(7);
  ExpectColor(Trace(text, 0, false), {1, 0.5f, 0.25f});
  ExpectColor(Trace(text, 0, true), {0, 0, 0});
  EXPECT_EQ(Trace(text, 0, false).rays.shadow, 0u);
  EXPECT_EQ(Trace(text, 0, true).rays.shadow, 1u);
}

TEST(WhittedShadow, RemovesTheHighlightToo) {
  ExpectColor(Trace(Wall("diffuse 0 0 0 specular 1 1 1 shininess 0") + FromTheFront() + Blocker(7),
                    0, true),
              {0, 0, 0});
}

TEST(WhittedShadow, OfADirectionalLightReachesFromAnyDistance) {
  ExpectColor(Trace(Wall("diffuse 1 1 1") + FromTheFront() + Blocker(1e30f), 0, true), {0, 0, 0});
}

// The light is at distance 2 from P; the shadow ray counts from a point 0.01 nearer to it. An
// object at t = 2 thus lies 0.01 behind the light, and still counts.
TEST(WhittedShadow, AHitExactlyAsFarAsTheLightCountsAndOneBeyondDoesNot) {
  const std::string lit = Wall("diffuse 1 1 1") + Light("type point color 4 4 4 attenuation 1");
  const float behind = 2.0f - 1.99f;
  ExpectColor(Trace(lit + Blocker(behind), 0, true), {0, 0, 0});
  ExpectColor(Trace(lit + Blocker(behind + 5e-7f), 0, true), {1, 1, 1});
  ExpectColor(Trace(lit + Blocker(5), 0, true), {1, 1, 1});
}

// The light comes from behind the wall; what is nearer than the offset is not seen.
TEST(WhittedShadow, RaysStartOneHundredthAlongThemselves) {
  const std::string lit = Wall("diffuse 0 0 0 specular 1 1 1 shininess 0") +
                          Light("type directional direction 0 0 1 color 1 1 1");
  ExpectColor(Trace(lit + Blocker(-2.009f), 0, true), {1, 1, 1});
  ExpectColor(Trace(lit + Blocker(-2.011f), 0, true), {0, 0, 0});
}

TEST(WhittedReflection, AddsWhatTheMirrorSeesTimesTheSpecularColour) {
  const std::string text =
      "Background { color 1 0.5 1 ambient_light 0 0 0 }" + Wall("diffuse 0 0 0 specular 0.5 0.5 1");
  ExpectColor(Trace(text, 1), {0.5f, 0.25f, 1});
  EXPECT_EQ(Trace(text, 1).rays.reflection, 1u);
  ExpectColor(Trace(text, 0), {0, 0, 0});
  EXPECT_EQ(Trace(text, 0).rays.reflection, 0u);
}

TEST(WhittedReflection, NeedsASpecularColourLongerThanOneHundredth) {
  const std::string background = "Background { color 1 1 1 ambient_light 0 0 0 }";
  ExpectColor(Trace(background + Wall("diffuse 0 0 0 specular 0.0099 0 0"), 1), {0, 0, 0});
  ExpectColor(Trace(background + Wall("diffuse 0 0 0 specular 0.0101 0 0"), 1), {0.0101f, 0, 0});
  // It is the length that counts, not a component.
  ExpectColor(Trace(background + Wall("diffuse 0 0 0 specular 0.0061 0.0081 0"), 1),
              {0.0061f, 0.0081f, 0});
}

/// A second wall at z = 2 faces the first; both take ambient light.
std::string FacingWalls(const std::string& material, const std::string& ambient) {
  return "Background { color 0 0 0 ambient_light " + ambient + " }" + Wall(material) +
         "Node { Component<Object> { type plane normal 0 0 -1 offset -2 } "
         "Component<Material> { index 0 } }";
}

TEST(WhittedReflection, NBouncesSeeNPlusOneSurfaces) {
  const std::string text = FacingWalls("diffuse 1 1 1 specular 0.5 0.5 0.5", "1 1 1");
  EXPECT_EQ(Trace(text, 0).color.x, 1.0f);
  EXPECT_EQ(Trace(text, 1).color.x, 1.5f);
  EXPECT_EQ(Trace(text, 2).color.x, 1.75f);
  EXPECT_EQ(Trace(text, 4).color.x, 1.9375f);
}

TEST(WhittedReflection, AHundredThousandBouncesNeedNoStack) {
  const Seen seen = Trace(FacingWalls("diffuse 1 1 1 specular 1 1 1", "0.0009765625 0 0"), 100000);
  EXPECT_EQ(seen.color.x, 100001.0f / 1024);
  EXPECT_EQ(seen.rays.reflection, 100000u);
}

// After 150 halvings nothing is left to add.
TEST(WhittedReflection, EndsWhenNothingCanBeAdded) {
  const Seen seen = Trace(FacingWalls("diffuse 1 1 1 specular 0.5 0.5 0.5", "1 1 1"), 4000000000);
  EXPECT_EQ(seen.color.x, 2.0f);
  EXPECT_LT(seen.rays.reflection, 160u);
}

TEST(WhittedEmission, ASurfaceThatShinesAddsItsRadiance) {
  const std::string lamp =
      "Scene { Transform { translate 0 0 5 } Component<Object> { type sphere radius 1 } "
      "Component<Material> { index 1 } Component<Light> { type area radiance 3 2 1 } ";
  const std::string materials =
      "Materials { Material { diffuse 1 1 1 specular 0.5 0.5 0.5 } "
      "Material { diffuse 0 0 0 } }";
  // In a mirror at z = -2, the lamp behind the camera is seen at half its radiance.
  ExpectColor(Trace(materials + lamp +
                        "Node { Component<Object> { type plane normal 0 0 1 offset -7 } "
                        "Component<Material> { index 0 } }",
                    1),
              {1.5f, 1, 0.5f});
}

TEST(WhittedEmission, AreaLightsDoNotIlluminate) {
  ExpectColor(
      Trace(Wall("diffuse 1 1 1") +
            "Node { Transform { translate 0 0 5 } Component<Object> { type sphere radius 1 } "
            "Component<Material> { index 1 } Component<Light> { type area radiance 9 9 9 } }"),
      {0, 0, 0});
}

}  // namespace
}  // namespace candela
