#include "scene/compile_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "loaders/course/scene_parser.h"

#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kStart =
    "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n"
    "Materials { Material { } Material { name white } Material { name red } }\n";
const std::string kSphere =
    "Component<Material> { index 0 } Component<Object> { type sphere radius 1 } ";

/// A compiled scene with what was said about it.
struct Compiled {
  explicit Compiled(const std::string& nodes) {
    Diagnostics diagnostics;
    const SceneSpec spec = ParseScene(std::make_shared<const std::string>("s"),
                                      kStart + "Scene { " + nodes + " }", "/nowhere", &diagnostics);
    EXPECT_FALSE(diagnostics.HasErrors());
    scene = CompileScene(spec, &diagnostics);
    EXPECT_EQ(scene == nullptr, diagnostics.HasErrors());
    lines = diagnostics.Lines();
  }
  std::unique_ptr<Scene> scene;
  std::vector<std::string> lines;
};

/// Transformed boxes are a few roundings larger than they need to be, never smaller.
void ExpectBox(const Bounds3& box, Vec3 min, Vec3 max) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(box.min[axis], min[axis]);
    EXPECT_GE(box.max[axis], max[axis]);
    EXPECT_NEAR(box.min[axis], min[axis], 1e-5);
    EXPECT_NEAR(box.max[axis], max[axis], 1e-5);
  }
}

/// The object that a ray along -z through (x, y) meets first, and at which distance from z = 10.
std::pair<uint32_t, float> FirstHit(const Scene& scene, float x, float y) {
  HitRecord hit;
  if (!scene.Intersect({{x, y, 10}, {0, 0, -1}}, &hit)) return {99, 0};
  return {hit.object, hit.t};
}

// Six bytes of text for a node must not take 65 kB of matrices each.
TEST(CompileScene, NodesWithinMovingOnesAreBounded) {
  const auto nodes = [](int count) {
    std::string text =
        "Keyframes { Transform { y_rotate 0 } Transform { y_rotate 2000 } } " + kSphere;
    for (int i = 0; i < count; ++i) text += "Node { } ";
    return text;
  };
  EXPECT_THAT(Compiled(nodes(1000)).lines, IsEmpty());
  const Compiled many(nodes(6000));
  EXPECT_EQ(many.scene, nullptr);
  ASSERT_THAT(many.lines, SizeIs(1));
  EXPECT_THAT(many.lines[0], testing::HasSubstr("move in more than 2097152 steps together"));
}

// Both see the same place of the picture: the right half of a floor of squares.
TEST(CompileScene, TexturesColourWhatBothIntegratorsSee) {
  const auto scene = testing_support::CompileText(
      "Camera { center 0 5 0 direction 0 -1 0 up 0 0 -1 fov 30 }\n"
      "Textures { Texture { name red type constant color 1 0 0 }\n"
      "  Texture { name squares type checker even texture red odd 0 1 0 } }\n"
      "Materials { Material { type diffuse albedo texture squares } Material { } }\n"
      "Scene { Transform { translate 10 0 0 }\n"
      "  Component<Object> { type plane normal 0 1 0 offset 0 } Component<Material> { index 0 }\n"
      "  Node { Component<Object> { type sphere radius 0.1 } Component<Material> { index 1 } } }");
  EXPECT_TRUE(scene->objects()[0].is_textured);
  EXPECT_FALSE(scene->objects()[1].is_textured);
  for (const auto& [x, colour] : {std::pair{10.5f, Rgb{1, 0, 0}}, std::pair{11.5f, Rgb{0, 1, 0}}}) {
    const Ray ray({x, 5, -0.5f}, {0, -1, 0});
    HitRecord hit;
    ASSERT_TRUE(scene->Intersect(ray, &hit));
    const Material& material = scene->material(hit);
    EXPECT_EQ(material.Phong(scene->ShadingAt(ray, hit)).diffuse, colour);
    EXPECT_EQ(material.Phong(scene->SurfaceAt(ray, hit)).diffuse, colour);
    EXPECT_EQ(scene->SurfaceAt(ray, hit).dpdu, (Vec3{1, 0, 0}));
  }
}

TEST(CompileScene, TransformsOfParentsAndChildrenCompose) {
  const Compiled c(
      "Transform { translate 10 0 0 } Node { Transform { scale 2 2 2 } Node { Transform "
      "{ translate 1 0 0 } " +
      kSphere + "} }");
  ASSERT_THAT(c.lines, IsEmpty());
  const SceneObject& object = c.scene->objects()[0];
  EXPECT_EQ(object.world_from_object.Point({0, 0, 0}), (Vec3{12, 0, 0}));
  EXPECT_EQ(object.world_from_object.Vector({1, 0, 0}), (Vec3{2, 0, 0}));
  EXPECT_EQ(object.object_from_world.Point({12, 0, 0}), (Vec3{0, 0, 0}));
  ExpectBox(c.scene->Bounds(), {10, -2, -2}, {14, 2, 2});
}

TEST(CompileScene, MirroredTransformsAreLegal) {
  const Compiled c("Transform { scale -1 1 1 } " + kSphere);
  EXPECT_THAT(c.lines, IsEmpty());
  EXPECT_THAT(c.scene->objects(), SizeIs(1));
}

TEST(CompileScene, ObjectsComeInTheOrderOfTheFile) {
  // Two spheres at one place: the one that was written first is hit.
  const Compiled c(
      "Node { Node { " + kSphere + "} } " +
      "Node { Component<Material> { name red } Component<Object> { type sphere radius 1 "
      "} } Component<Material> { name white } Component<Object> { type sphere radius 2 }");
  ASSERT_THAT(c.scene->objects(), SizeIs(3));
  // A node's own object stands before those of its children.
  EXPECT_EQ(c.scene->objects()[0].material, 1u);
  EXPECT_EQ(c.scene->objects()[1].material, 0u);
  EXPECT_EQ(c.scene->objects()[2].material, 2u);
  EXPECT_EQ(FirstHit(*c.scene, 0, 0), std::pair(0u, 8.0f));
}

TEST(CompileScene, OfEqualDistancesTheFirstObjectCounts) {
  const Compiled c("Node { " + kSphere + "} Node { " + kSphere + "}");
  EXPECT_EQ(FirstHit(*c.scene, 0, 0), std::pair(0u, 9.0f));
}

TEST(CompileScene, MaterialsAreFoundByIndexAndByName) {
  const Compiled c(
      "Node { Component<Material> { index 2 } Component<Object> { type sphere radius 1 } } "
      "Node { Component<Material> { name red } Component<Object> { type sphere radius 1 } }");
  EXPECT_THAT(c.lines, IsEmpty());
  EXPECT_EQ(c.scene->objects()[0].material, 2u);
  EXPECT_EQ(c.scene->objects()[1].material, 2u);
}

TEST(CompileScene, ObjectsWithoutMaterialShareOneDefault) {
  const Compiled c(
      "Node { Component<Object> { type sphere radius 1 } } "
      "Node { Component<Object> { type sphere radius 1 } }");
  EXPECT_THAT(c.lines,
              ElementsAre("s:3:41: warning: the object has no material; the default one is used",
                          "s:3:93: warning: the object has no material; the default one is used"));
  EXPECT_THAT(c.scene->materials(), SizeIs(4));
  EXPECT_EQ(c.scene->objects()[0].material, 3u);
  EXPECT_EQ(c.scene->objects()[1].material, 3u);
}

TEST(CompileScene, ObjectsUnderASingularTransformAreLeftOut) {
  const Compiled c("Node { Transform { scale 1 0 1 } " + kSphere + "} Node { " + kSphere + "}");
  EXPECT_THAT(c.lines,
              ElementsAre("s:3:16: warning: the object is left out: its transform is singular (it "
                          "has no inverse in single precision)"));
  EXPECT_THAT(c.scene->objects(), SizeIs(1));
}

TEST(CompileScene, UnboundedShapesStandBesideTheTree) {
  const Compiled c(
      "Node { Component<Material> { index 0 } Component<Object> { type plane normal 0 0 1 "
      "offset -5 } } Node { " +
      kSphere + "}");
  ExpectBox(c.scene->Bounds(), {-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(FirstHit(*c.scene, 0, 0), std::pair(1u, 9.0f));
  EXPECT_EQ(FirstHit(*c.scene, 1000, 0), std::pair(0u, 15.0f));
}

TEST(CompileScene, LightsComeInTheOrderOfTheFileAtTheirNodes) {
  const Compiled c(
      "Component<Light> { type directional direction 0 -1 0 } "
      "Transform { translate 1 2 3 } Node { Component<Light> { type point } }");
  ASSERT_THAT(c.scene->lights(), SizeIs(2));
  // Seen from one unit below, the point light is straight above.
  const LightSample sample = c.scene->lights()[1]->SampleIncident({1, 1, 3});
  EXPECT_EQ(sample.direction, (Vec3{0, 1, 0}));
  EXPECT_EQ(sample.distance, 1);
}

TEST(CompileScene, AnAreaLightShinesFromTheObjectOfItsNode) {
  const Compiled c(
      "Node { Component<Light> { type point } } Node { Component<Light> { type area } " + kSphere +
      "} Node { " + kSphere + "}");
  EXPECT_EQ(c.scene->objects()[0].light, 1u);
  EXPECT_EQ(c.scene->objects()[1].light, SceneObject::kNoLight);
}

TEST(CompileScene, ALightBeyondSinglePrecisionIsLeftOut) {
  const Compiled c(
      "Transform { translate 3e38 0 0 translate 3e38 0 0 } Component<Light> { type point }");
  EXPECT_THAT(c.lines, SizeIs(1));
  EXPECT_THAT(c.scene->lights(), IsEmpty());
}

TEST(CompileScene, AnEmptySceneIsAScene) {
  const Compiled c("");
  EXPECT_THAT(c.lines, IsEmpty());
  EXPECT_EQ(FirstHit(*c.scene, 0, 0).first, 99u);
}

TEST(CompileScene, NamesAreNotLookedForInADamagedList) {
  Diagnostics diagnostics;
  const SceneSpec spec = ParseScene(
      nullptr, kStart + "Materials { Texture { } } Scene { " + kSphere + "}", {}, &diagnostics);
  EXPECT_EQ(CompileScene(spec, &diagnostics), nullptr);
  EXPECT_EQ(diagnostics.ErrorCount(), 1u);
}

}  // namespace
}  // namespace candela
