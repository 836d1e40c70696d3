// Materials in scenes whose light is known: furnaces and panes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

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
using testing_support::kCamera;

IntegratorOptions SeedOne() {
  IntegratorOptions options;
  options.seed = 1;
  return options;
}

/// A ball of the last of the materials, which the camera sees, in an environment of radiance 1.
std::string Furnace(const std::string& materials) {
  return fmt::format(
      "{}Background {{ color 1 1 1 }}\n"
      "Textures {{ Texture {{ name half type constant color 0.6 0.6 0.6 }} }}\n"
      "Materials {{ {} }}\n"
      "Scene {{ Transform {{ translate 0 0 -3 }} Component<Object> {{ type sphere radius 1 }}\n"
      "Component<Material> {{ name ball }} }}",
      kCamera, materials);
}

/// What the path tracer sees of such a ball: no darker and no brighter than what surrounds it.
void ExpectInvisible(const std::string& materials, double tolerance, uint32_t pixels = 64) {
  SCOPED_TRACE(materials);
  const auto scene = CompileText(Furnace(materials));
  const PathIntegrator path(*scene, SeedOne());
  for (const Vec2 image_point : {Vec2{0, 0}, Vec2{0.25f, -0.1f}, Vec2{-0.3f, 0.15f}}) {
    const Estimate estimate = EstimateRadiance(path, image_point, pixels, 1024);
    EXPECT_NEAR(estimate.mean, 1, tolerance + test::kLargestDeviate * estimate.error);
    EXPECT_LE(estimate.error, testing_support::LargestError(3e-3));
  }
}

// P4: where the model is exact.
TEST(WhiteBall, OfASmoothMaterialIsInvisibleInTheFurnace) {
  ExpectInvisible("Material { name ball type diffuse albedo 1 1 1 }", 1e-5);
  ExpectInvisible("Material { name ball type diffuse albedo 1 1 1 roughness 0.8 }", 1e-4);
  ExpectInvisible("Material { name ball type mirror }", 1e-5);
  ExpectInvisible("Material { name ball type dielectric ior glass }", 1e-5);
  ExpectInvisible("Material { name ball type dielectric ior diamond }", 1e-5);
  ExpectInvisible("Material { name ball type dielectric thin true }", 1e-5);
  ExpectInvisible("Material { name ball type plastic albedo 1 1 1 }", 1e-4);
}

// P4
TEST(WhiteBall, OfARoughMaterialIsInvisibleInTheFurnace) {
  for (const char* roughness : {"0.2", "0.4", "0.6", "0.8", "1", "texture half"}) {
    const auto expect_invisible = [&](const std::string& material, uint32_t pixels) {
      ExpectInvisible(fmt::format("Material {{ name ball {} roughness {} }}", material, roughness),
                      5e-3, pixels);
    };
    expect_invisible("type conductor eta 0 0 0 k 3 3 3", 64);
    expect_invisible("type plastic albedo 1 1 1", 64);
    expect_invisible("type principled base_color 1 1 1", 64);
    expect_invisible("type principled base_color 1 1 1 metallic 0.5", 64);
    expect_invisible("type retroreflective albedo 1 1 1", 64);
    // Light that is caught inside for long comes out in few and bright paths.
    expect_invisible("type dielectric ior glass", 256);
    expect_invisible("type principled base_color 1 1 1 transmission 0.9", 256);
  }
  ExpectInvisible("Material { name ball type conductor eta 0 0 0 k 3 3 3 alpha_x 0.6 alpha_y 0.1 }",
                  5e-3);
}

// P4: one number of a pixel's colour is looked at; over a bubble of equal thickness all of them
// vary.
TEST(WhiteBall, UnderAThinFilmIsInvisibleInTheFurnace) {
  ExpectInvisible("Material { name ball type dielectric ior 1 film_thickness 400 }", 2e-3);
  ExpectInvisible("Material { name ball type dielectric film_thickness 250 film_ior 2.2 }", 2e-3);
  ExpectInvisible(
      "Material { name ball type dielectric film_thickness 250 film_ior 2.2 roughness 0.5 }", 5e-3,
      256);
  ExpectInvisible(
      "Material { name ball type dielectric film_ior 1.8 film_thickness texture half "
      "film_thickness_range 0 500 }",
      2e-3);
  ExpectInvisible("Material { name ball type dielectric film_ior 2.2 film_thickness 250 abbe 20 }",
                  5e-3, 256);
  ExpectInvisible(
      "Material { name ball type dielectric abbe 2 film_ior 1.5 film_thickness 150 roughness 1 }",
      5e-3, 1024);
  ExpectInvisible("Material { name ball type conductor eta 0 0 0 k 3 3 3 film_thickness 250 }",
                  2e-3);
  ExpectInvisible(
      "Material { name ball type conductor eta 0 0 0 k 3 3 3 roughness texture half "
      "film_thickness texture half }",
      5e-3);
}

// P4
TEST(WhiteBall, OfAMixtureOrAVeilIsInvisibleInTheFurnace) {
  const std::string parts =
      "Material { name a type mirror } Material { name b type diffuse albedo 1 1 1 }";
  ExpectInvisible(parts + "Material { name ball type mix first a second b amount 0.3 }", 1e-5);
  ExpectInvisible(parts + "Material { name ball type mask material b opacity texture half }", 1e-5);
}

/// Something in front of a black wall, seen head-on: nodes whose material is `glass`, which
/// `materials` names. What surrounds the camera has the first radiance, and the wall the second.
std::string BeforeAWall(const std::string& materials, const std::string& nodes, float around,
                        float wall) {
  return fmt::format(
      "Camera {{ center 0 0 5 direction 0 0 -1 up 0 1 0 fov 90 }}\n"
      "Background {{ color {0} {0} {0} }}\n"
      "Materials {{ Material {{ name black type diffuse albedo 0 0 0 }} {1} }}\n"
      "Scene {{ {2}\n"
      "  Node {{ Component<Material> {{ name black }}\n"
      "    Component<Object> {{ type plane normal 0 0 1 offset -3 }}\n"
      "    Component<Light> {{ type area radiance {3} {3} {3} }} }} }}",
      around, materials, nodes, wall);
}

std::string PlaneOf(const char* material, const char* plane) {
  return fmt::format(
      "Node {{ Component<Material> {{ name {} }} Component<Object> {{ type plane {} }} }}\n",
      material, plane);
}

std::string Glass(const std::string& params) {
  return "Material { name glass type dielectric ior 1.5 " + params + " }";
}

/// The two faces of a glass plate from z = 0 to z = -1.
std::string Faces() {
  return PlaneOf("glass", "normal 0 0 1 offset 0") + PlaneOf("glass", "normal 0 0 -1 offset 1");
}

std::string Plate(const std::string& params, float around, float wall) {
  return BeforeAWall(Glass(params), Faces(), around, wall);
}

/// The same plate as one surface without thickness.
std::string Pane(const std::string& params, float around, float wall) {
  return BeforeAWall(Glass("thin true thickness 1 " + params),
                     PlaneOf("glass", "normal 0 0 1 offset 0"), around, wall);
}

void ExpectHeadOn(const std::string& text, double expected) {
  const auto scene = CompileText(text);
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, SeedOne()), {0, 0}, 512, 2048), expected);
}

// CF19: T = (1 - R)^2 a / (1 - R^2 a^2) of the light behind, R + R (1 - R)^2 a^2 / (1 - R^2 a^2) of
// that in front, with R = 0.04 at each face and a = exp(-sigma t) on the way between them.
TEST(GlassPlate, TransmitsAndReflectsAllInnerBounces) {
  ExpectHeadOn(Plate("", 0, 1), 0.923077);
  ExpectHeadOn(Plate("", 1, 0), 0.076923);
}

// CF19
TEST(GlassPlate, TintedItAbsorbsOnTheWay) {
  ExpectHeadOn(Plate("absorption 0.5 0.5 0.5", 0, 1), 0.559308);
  ExpectHeadOn(Plate("absorption 0.5 0.5 0.5", 1, 0), 0.053569);
}

// CF19
TEST(GlassPane, IsThePlateInOneSurface) {
  ExpectHeadOn(Pane("", 0, 1), 0.923077);
  ExpectHeadOn(Pane("", 1, 0), 0.076923);
  ExpectHeadOn(Pane("absorption 0.5 0.5 0.5", 0, 1), 0.559308);
  ExpectHeadOn(Pane("absorption 0.5 0.5 0.5", 1, 0), 0.053569);
}

// A hole is nothing: the medium on both sides of it is the same.
TEST(GlassPlate, TintedItAbsorbsBehindAHoleInsideAsWell) {
  const std::string materials = Glass("absorption 0.5 0.5 0.5") +
                                "Material { name nothing type mask material black opacity 0 }";
  const std::string nodes = Faces() + PlaneOf("nothing", "normal 0 0 1 offset -0.25");
  ExpectHeadOn(BeforeAWall(materials, nodes, 0, 1), 0.559308);
}

TEST(GlassPlate, TintedItAbsorbsAsAPartOfAMixture) {
  const std::string materials =
      "Material { name tinted type dielectric ior 1.5 absorption 0.5 0.5 0.5 }"
      "Material { name glass type mix first tinted second tinted amount 0.25 }";
  ExpectHeadOn(BeforeAWall(materials, Faces(), 0, 1), 0.559308);
}

// Nothing is reflected and nothing comes through: the choice between the two has no odds.
TEST(GlassPane, WithoutReflectionAndOpaqueIsBlack) {
  const std::string pane =
      "Material { name glass type dielectric thin true thickness 1 ior 1 absorption 200 200 200 }";
  ExpectHeadOn(BeforeAWall(pane, PlaneOf("glass", "normal 0 0 1 offset 0"), 1, 1), 0);
}

}  // namespace
}  // namespace candela
