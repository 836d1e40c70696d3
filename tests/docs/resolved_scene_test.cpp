// A scene that is written out with everything that it leaves to defaults is the same scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "base/files.h"
#include "integrators/registry.h"
#include "loaders/course/scene_parser.h"
#include "loaders/course/scene_writer.h"
#include "scene/compile_scene.h"
#include "tests/docs/scene_examples.h"
#include "tests/support/render_scene.h"

namespace candela::docs {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A scene, the text that it resolves to, and the pictures of both integrators.
struct Resolved {
  std::string text;
  std::vector<Image> pictures;
};

std::optional<Resolved> Resolve(const std::string& scene, const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  const auto name = std::make_shared<const std::string>("scene.txt");
  SceneSpec resolved;
  const auto compiled = CompileScene(ParseScene(name, scene, folder, &diagnostics), &diagnostics,
                                     {AcceleratorKind::kBvh, &resolved});
  EXPECT_FALSE(diagnostics.HasErrors()) << diagnostics.Lines()[0] << "\nin: " << scene;
  if (!compiled) return std::nullopt;

  Resolved result{WriteScene(resolved), {}};
  RenderOptions options = testing_support::WholePicture(24, 18);
  options.pattern = SamplePattern::kFilter;
  options.samples = 2;
  for (const IntegratorEntry& entry : IntegratorEntries()) {
    IntegratorOptions light;
    light.bounces = 3;
    light.shadows = true;
    const auto integrator = entry.create(*compiled, light);
    // Paths know no highlights of the course; then there is one picture.
    if (integrator) result.pictures.push_back(testing_support::RenderImage(**integrator, options));
  }
  return result;
}

bool IsSame(const Image& a, const Image& b) {
  const auto x = a.Samples(), y = b.Samples();
  return std::equal(x.begin(), x.end(), y.begin(), y.end());
}

void ExpectResolvesToItself(const std::string& scene, const std::filesystem::path& folder) {
  const auto once = Resolve(scene, folder);
  ASSERT_TRUE(once);
  const auto twice = Resolve(once->text, folder);
  ASSERT_TRUE(twice);
  EXPECT_EQ(twice->text, once->text);
  ASSERT_EQ(twice->pictures.size(), once->pictures.size());
  ASSERT_GE(once->pictures.size(), 1u);
  for (size_t i = 0; i < once->pictures.size(); ++i) {
    EXPECT_TRUE(IsSame(once->pictures[i], twice->pictures[i])) << IntegratorEntries()[i].name;
  }
}

TEST(ResolvedScene, IsTheSceneForThoseThatShip) {
  size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("assets")) {
    if (entry.path().extension() != ".txt") continue;
    SCOPED_TRACE(entry.path());
    const auto text = ReadFile(entry.path());
    ASSERT_TRUE(text);
    ExpectResolvesToItself(*text, entry.path().parent_path());
    ++count;
  }
  EXPECT_GE(count, 11u);
}

TEST(ResolvedScene, IsTheSceneForTheExamplesOfTheManual) {
  size_t count = 0;
  for (const SceneExample& example : SceneExamples()) {
    if (example.is_wrong) continue;
    SCOPED_TRACE(example.text);
    ExpectResolvesToItself(example.text, kExampleFolder);
    ++count;
  }
  EXPECT_GE(count, 25u);
}

// Products of steps may leave single precision and come back.
TEST(ResolvedScene, HoldsTransformsBeyondSinglePrecision) {
  ExpectResolvesToItself(
      "Camera { center 0 0 9 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Background { ambient_light 1 1 1 }\n"
      "Materials { Material { diffuse 1 0 0 } }\n"
      "Scene {\n"
      "  Node { Transform { scale 1e30 1e30 1e30  scale 1e30 1e30 1e30 }\n"
      "    Node { Transform { scale 1e-30 1e-30 1e-30  scale 1e-30 1e-30 1e-30 }\n"
      "      Component<Material> { index 0 } Component<Object> { type sphere radius 1 } } }\n"
      "}",
      ".");
}

// An object that is left out keeps the material that it would have had.
TEST(ResolvedScene, HoldsTheMaterialOfWhatIsLeftOut) {
  ExpectResolvesToItself(
      "Camera { center 0 0 9 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Background { color 1 1 1 ambient_light 1 1 1 }\n"
      "Scene { Component<Object> {\n"
      "  type triangle vertex0 0 0 0 vertex1 0 0 0 vertex2 0 1 0 } }",
      ".");
}

// A default appears with its value, and what would mean something else if it was written does not.
TEST(ResolvedScene, HoldsTheDefaults) {
  const auto resolved = Resolve(
      "Camera { center 0 0 9 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Materials { Material { } Material { name g type dielectric ior water } }\n"
      "Scene { Component<Object> { type sphere radius 1.50 } Component<Light> { type area } }",
      ".");
  ASSERT_TRUE(resolved);
  EXPECT_THAT(resolved->text, HasSubstr("\n  aperture 0\n"));
  EXPECT_THAT(resolved->text,
              HasSubstr("\n  Material { type phong  specular 0 0 0  shininess 0  "));
  EXPECT_THAT(resolved->text,
              HasSubstr("{ name g  type dielectric  ior 1.333  absorption 0 0 0  "));
  EXPECT_THAT(resolved->text, HasSubstr("\n  Component<Material> { index 2 }\n"));
  EXPECT_THAT(resolved->text, HasSubstr("{ type sphere  radius 1.5 }"));
  EXPECT_THAT(resolved->text, HasSubstr("{ type area  radiance 1 1 1  two_sided true }"));
}

}  // namespace
}  // namespace candela::docs
