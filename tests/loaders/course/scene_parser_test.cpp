// What scenes mean. What is said about wrong ones is compared in tests/malformed.
#include "loaders/course/scene_parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cameras/registry.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kCamera = "Camera { center 1 2 3 direction 0 0 -1 up 0 1 0 fov 30 }\n";

SceneSpec Parse(const std::string& text, std::vector<std::string>* lines = nullptr) {
  Diagnostics diagnostics;
  SceneSpec spec =
      ParseScene(std::make_shared<const std::string>("s"), text, "/nowhere", &diagnostics);
  if (lines) {
    *lines = diagnostics.Lines();
  } else {
    EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  }
  return spec;
}

/// What a parameter of the camera turns out to be.
std::string CameraWords(const SceneSpec& spec, const char* name,
                        std::vector<std::string>* lines = nullptr) {
  Diagnostics diagnostics;
  ParamSet resolved;
  const auto camera = CreateCamera(spec.camera, &diagnostics, &resolved);
  if (lines) {
    *lines = diagnostics.Lines();
  } else {
    EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  }
  std::string words;
  if (const Param* param = resolved.Find(name)) {
    for (const ParamWord& word : param->words) words += (words.empty() ? "" : " ") + word.text;
  }
  return words;
}

TEST(SceneParser, CameraAndBackground) {
  const SceneSpec spec = Parse("Background { color .1 .2 .3 ambient_light 1 2 3 cube_map sky }" +
                               kCamera + "Scene { }");
  EXPECT_EQ(spec.camera.type, "perspective");
  EXPECT_EQ(CameraWords(spec, "center"), "1 2 3");
  EXPECT_EQ(CameraWords(spec, "direction"), "0 0 -1");
  EXPECT_EQ(CameraWords(spec, "up"), "0 1 0");
  EXPECT_EQ(CameraWords(spec, "fov"), "30");
  EXPECT_EQ(spec.background.color, (Rgb{.1f, .2f, .3f}));
  EXPECT_EQ(spec.background.ambient_light, (Rgb{1, 2, 3}));
  EXPECT_EQ(spec.background.cube_map, "sky");
}

TEST(SceneParser, ACameraMayHaveALens) {
  const std::string camera = "Camera { center 1 2 3 direction 0 0 -1 up 0 1 0 fov 30 ";
  const SceneSpec spec = Parse(camera + "aperture .5 focus_distance 4 blades 7 } Scene { }");
  EXPECT_EQ(CameraWords(spec, "aperture"), "0.5");
  EXPECT_EQ(CameraWords(spec, "focus_distance"), "4");
  EXPECT_EQ(CameraWords(spec, "blades"), "7");
  EXPECT_EQ(CameraWords(Parse(kCamera + "Scene { }"), "aperture"), "0");

  std::vector<std::string> lines;
  CameraWords(Parse(camera + "aperture .5 } Scene { }"), "aperture", &lines);
  EXPECT_THAT(lines,
              ElementsAre("s:1:65: error: a camera with an 'aperture' needs 'focus_distance'"));
  CameraWords(Parse(camera + "blades 2 } Scene { }"), "blades", &lines);
  EXPECT_THAT(lines, ElementsAre("s:1:63: error: 'blades' expects 3 to 100, or 0 for a round "
                                 "opening, found '2'"));
}

TEST(SceneParser, ACameraMayBeOfAnotherKind) {
  const std::string camera = "Camera { center 1 2 3 direction 0 0 -1 up 0 1 0 height 3 type ";
  const SceneSpec spec = Parse(camera + "orthographic } Scene { }");
  EXPECT_EQ(spec.camera.type, "orthographic");
  EXPECT_EQ(spec.camera.where.column, 63u);
  EXPECT_EQ(CameraWords(spec, "height"), "3");

  std::vector<std::string> lines;
  CameraWords(Parse(camera + "ortographic } Scene { }"), "height", &lines);
  EXPECT_THAT(lines, ElementsAre("s:1:63: error: there is no camera of type 'ortographic' (did you "
                                 "mean 'orthographic'?); known: 'perspective', 'orthographic', "
                                 "'fisheye' or 'panoramic'"));
}

TEST(SceneParser, ABackgroundMayBeAnEnvironment) {
  const SceneSpec spec =
      Parse(kCamera + "Background { environment sky.exr scale 2 rotate -30 } Scene { }");
  EXPECT_EQ(spec.background.environment, "sky.exr");
  EXPECT_EQ(spec.background.environment_scale, 2);
  EXPECT_EQ(spec.background.environment_rotate_degrees, -30);

  std::vector<std::string> lines;
  Parse(kCamera + "Background { environment sky.exr cube_map sky } Scene { }", &lines);
  EXPECT_THAT(lines, ElementsAre("s:2:26: error: a background has a 'cube_map' or an "
                                 "'environment', not both"));
  Parse(kCamera + "Background { scale 2 } Scene { }", &lines);
  EXPECT_THAT(lines, ElementsAre("s:2:20: error: 'scale' is for an 'environment' or a 'sky', of "
                                 "which there is none"));
}

TEST(SceneParser, MaterialsArePhongUnlessTheySayOtherwise) {
  const SceneSpec spec =
      Parse(kCamera +
            "Materials { Material { name red shininess 2 } Material { type diffuse } } Scene { }");
  ASSERT_THAT(spec.materials, SizeIs(2));
  EXPECT_EQ(spec.materials[0].material.type, "phong");
  EXPECT_EQ(spec.materials[0].name, "red");
  ASSERT_THAT(spec.materials[0].material.params.params, SizeIs(1));  // The name is taken out.
  EXPECT_EQ(spec.materials[0].material.params.params[0].name, "shininess");
  EXPECT_EQ(spec.materials[1].material.type, "diffuse");
}

TEST(SceneParser, ATextureStandsWhereAValueMay) {
  const SceneSpec spec = Parse(
      kCamera +
      "Textures { Texture { name texture type checker even texture a scale 2 2 } }\n"
      "Materials { Material { name texture diffuse texture wood specular 1 1 1 } } Scene { }");
  ASSERT_THAT(spec.textures, SizeIs(1));
  EXPECT_EQ(spec.textures[0].name, "texture");
  EXPECT_EQ(spec.textures[0].texture.type, "checker");
  ASSERT_THAT(spec.textures[0].texture.params.params, SizeIs(2));
  EXPECT_EQ(spec.textures[0].texture.params.params[0].words[1].text, "a");
  EXPECT_EQ(spec.materials[0].name, "texture");
  const auto& params = spec.materials[0].material.params.params;
  ASSERT_THAT(params, SizeIs(2));
  ASSERT_THAT(params[0].words, SizeIs(2));
  EXPECT_EQ(params[0].words[0].text, "texture");
  EXPECT_EQ(params[0].words[1].text, "wood");
  EXPECT_THAT(params[1].words, SizeIs(3));
}

// A folder of that name stays what it was.
TEST(SceneParser, InABackgroundTextureIsAWordLikeOthers) {
  const SceneSpec spec =
      Parse("Background { cube_map texture color 1 2 3 }" + kCamera + "Scene { }");
  EXPECT_EQ(spec.background.cube_map, "texture");
  EXPECT_EQ(spec.background.color, (Rgb{1, 2, 3}));
}

TEST(SceneParser, NodesAreListedInTheOrderOfTheFile) {
  const SceneSpec spec =
      Parse(kCamera + "Scene { Node { Node { } } Component<Light> { type point } Node { } }");
  ASSERT_THAT(spec.nodes, SizeIs(4));
  EXPECT_EQ(spec.nodes[0].parent, NodeSpec::kNoParent);
  EXPECT_EQ(spec.nodes[1].parent, 0u);
  EXPECT_EQ(spec.nodes[2].parent, 1u);
  EXPECT_EQ(spec.nodes[3].parent, 0u);
  EXPECT_TRUE(spec.nodes[0].light);
}

TEST(SceneParser, TransformStepsComposeFromLeftToRight) {
  const SceneSpec spec =
      Parse(kCamera + "Scene { Transform { translate 1 2 3 z_rotate 90 scale 2 3 4 } }");
  // Scaled first, then turned (x to y, y to -x), then moved: the columns are the images of the
  // axes.
  const auto& m = spec.nodes[0].parent_from_node.m;
  EXPECT_EQ(m[0], (std::array<double, 4>{0, -3, 0, 1}));
  EXPECT_EQ(m[1], (std::array<double, 4>{2, 0, 0, 2}));
  EXPECT_EQ(m[2], (std::array<double, 4>{0, 0, 4, 3}));
}

TEST(SceneParser, RotationsTurnCounterClockwiseAboutTheirAxis) {
  for (const auto& [word, row, column] :
       {std::tuple("x_rotate", 2, 1), std::tuple("y_rotate", 0, 2), std::tuple("z_rotate", 1, 0)}) {
    const SceneSpec spec = Parse(kCamera + "Scene { Transform { " + word + " 90 } }");
    EXPECT_EQ(spec.nodes[0].parent_from_node.m[row][column], 1) << word;
  }
}

TEST(SceneParser, LayoutMeansNothing) {
  const SceneSpec spaced = Parse(kCamera + "Scene {\n\tNode {\r\n # a comment }\n }\n}\n");
  const SceneSpec glued = Parse(
      "\xEF\xBB\xBF"
      "Camera{center 1 2 3 direction 0 0 -1 up 0 1 0 fov 30}Scene{Node{}}");
  EXPECT_EQ(spaced.nodes.size(), 2u);
  EXPECT_EQ(glued.nodes.size(), 2u);
  EXPECT_EQ(CameraWords(glued, "fov"), "30");
}

TEST(SceneParser, SectionsMayComeInAnyOrder) {
  const SceneSpec spec = Parse("Scene { } Materials { Material { } } " + kCamera);
  EXPECT_THAT(spec.materials, SizeIs(1));
}

TEST(SceneParser, ParametersMayComeInAnyOrderTheTypeIncluded) {
  const SceneSpec spec = Parse(kCamera + "Scene { Component<Object> { radius 2 type sphere } }");
  EXPECT_EQ(spec.nodes[0].object->type, "sphere");
  EXPECT_EQ(spec.nodes[0].object->where.column, 43u);
}

TEST(SceneParser, ALaterSectionReplacesScenesAndMaterialsButAddsToTheOthers) {
  std::vector<std::string> lines;
  const SceneSpec spec = Parse(kCamera +
                                   "Camera { fov 40 }\nMaterials { Material { } Material { } }\n"
                                   "Materials { Material { } }\nScene { Node { } }\nScene { }",
                               &lines);
  EXPECT_EQ(CameraWords(spec, "fov"), "40");
  EXPECT_EQ(CameraWords(spec, "center"), "1 2 3");
  EXPECT_THAT(spec.materials, SizeIs(1));
  EXPECT_THAT(spec.nodes, SizeIs(1));
  EXPECT_THAT(lines, ElementsAre("s:2:1: warning: a second block 'Camera'; the last one counts",
                                 "s:4:1: warning: a second block 'Materials'; the last one counts",
                                 "s:6:1: warning: a second block 'Scene'; the last one counts"));
}

TEST(SceneParser, MaterialsOfOneNameAreToldApartByNobody) {
  std::vector<std::string> lines;
  Parse(kCamera + "Materials { Material { name a } Material { name a } } Scene { }", &lines);
  EXPECT_THAT(lines, ElementsAre("s:2:49: error: a material named 'a' stands in line 2 already"));
}

TEST(SceneParser, ReferencesNameMaterialsByIndexOrName) {
  const SceneSpec spec = Parse(kCamera +
                               "Scene { Component<Material> { index 4294967296 } Node { "
                               "Component<Material> { name white } } }");
  EXPECT_EQ(spec.nodes[0].material->index, 4294967296);
  EXPECT_EQ(spec.nodes[1].material->name, "white");
}

}  // namespace
}  // namespace candela
