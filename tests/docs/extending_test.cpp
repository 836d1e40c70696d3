// Compiled together with the files of docs/extending.md: the shape that the document adds is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"
#include "shapes/registry.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::unique_ptr<Scene> Compile(const std::string& object, Diagnostics* diagnostics) {
  const std::string text =
      "Camera { center 0 0 10  direction 0 0 -1  up 0 1 0  fov 30 }\n"
      "Materials { Material { diffuse 1 1 1 } }\n"
      "Scene { Component<Material> { index 0 } Component<Object> {\n" +
      object + "} }";
  const auto name = std::make_shared<const std::string>("scene.txt");
  const SceneSpec spec = ParseScene(name, text, ".", diagnostics);
  return CompileScene(spec, diagnostics);
}

TEST(Extending, ScenesMayNameTheNewShape) {
  Diagnostics diagnostics;
  const auto scene = Compile("type ring radius 1 hole 0.5", &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  ASSERT_NE(scene, nullptr);
  HitRecord hit;
  ASSERT_TRUE(scene->Intersect(Ray({0.75f, 0, 10}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 10);
}

TEST(Extending, TheNewShapeReportsWrongParameters) {
  Diagnostics diagnostics;
  Compile("type ring radius -1 radios 2", &diagnostics);
  EXPECT_THAT(
      diagnostics.Lines(),
      ElementsAre("scene.txt:4:18: error: 'radius' expects a positive number, found '-1'",
                  "scene.txt:4:21: error: parameter 'radios' is not used by 'ring' (did you mean "
                  "'radius'?)"));
}

TEST(Extending, ItsRowHasAnExample) {
  const auto rows = ShapeEntries();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [](const auto& each) { return each.name == "ring"; });
  ASSERT_NE(row, rows.end());
  EXPECT_EQ(row->example, "type ring radius 1 hole 0.5");
}

}  // namespace
}  // namespace candela
