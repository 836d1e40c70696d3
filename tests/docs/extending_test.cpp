// Compiled together with the files of docs/extending.md: what the document adds is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lights/registry.h"
#include "loaders/course/scene_parser.h"
#include "materials/registry.h"
#include "scene/compile_scene.h"
#include "shapes/registry.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A scene with one node, made of the material that `material` describes.
std::unique_ptr<Scene> Compile(const std::string& material, const std::string& node,
                               Diagnostics* diagnostics) {
  const std::string text =
      "Camera { center 0 0 10  direction 0 0 -1  up 0 1 0  fov 30 }\n"
      "Materials { Material { " +
      material + " } }\nScene { Component<Material> { index 0 } " + node + " }";
  const auto name = std::make_shared<const std::string>("scene.txt");
  const SceneSpec spec = ParseScene(name, text, ".", diagnostics);
  return CompileScene(spec, diagnostics);
}

std::unique_ptr<Scene> CompileObject(const std::string& object, Diagnostics* diagnostics) {
  return Compile("diffuse 1 1 1", "Component<Object> {\n" + object + " }", diagnostics);
}

TEST(Extending, ScenesMayNameTheNewShape) {
  Diagnostics diagnostics;
  const auto scene = CompileObject("type ring radius 1 hole 0.5", &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  ASSERT_NE(scene, nullptr);
  HitRecord hit;
  ASSERT_TRUE(scene->Intersect(Ray({0.75f, 0, 10}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 10);
}

TEST(Extending, TheNewShapeReportsWrongParameters) {
  Diagnostics diagnostics;
  CompileObject("type ring radius -1 radios 2", &diagnostics);
  EXPECT_THAT(
      diagnostics.Lines(),
      ElementsAre("scene.txt:4:18: error: 'radius' expects a positive number, found '-1'",
                  "scene.txt:4:21: error: parameter 'radios' is not used by 'ring' (did you mean "
                  "'radius'?)"));
}

TEST(Extending, ScenesMayNameTheNewMaterialAndTheNewLight) {
  Diagnostics diagnostics;
  const auto scene = Compile(
      "type worn_mirror wear 0.25",
      "Component<Object> { type sphere radius 1 } Component<Light> { type led direction 0 -1 0 }",
      &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->materials()[0]->Phong({}).diffuse.x, 0.25f);
  EXPECT_EQ(scene->lights()[0]->SampleIncident({0, -1, 0}).radiance[0], 1 / 20.0f);
}

template <class Entry>
std::string_view ExampleOf(std::span<const Entry> rows, std::string_view name) {
  for (const Entry& row : rows) {
    if (row.name == name) return row.example;
  }
  return "";
}

TEST(Extending, TheirRowsHaveExamples) {
  EXPECT_EQ(ExampleOf(ShapeEntries(), "ring"), "type ring radius 1 hole 0.5");
  EXPECT_NE(ExampleOf(MaterialEntries(), "worn_mirror"), "");
  EXPECT_NE(ExampleOf(LightEntries(), "led"), "");
}

}  // namespace
}  // namespace candela
