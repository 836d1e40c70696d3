// Scenes of several files. What is said about wrong ones is compared in tests/malformed as well.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "loaders/course/scene_parser.h"
#include "loaders/course/scene_text.h"
#include "scene/compile_scene.h"
#include "scene/input_files.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_support::Put;

const std::string kCamera = "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n";
const std::string kSphere = "Component<Object> { type sphere radius 1 }";

class IncludeTest : public testing::Test {
 protected:
  IncludeTest() {
    std::filesystem::create_directories(folder_ / "parts/deep");
    std::filesystem::current_path(folder_.path());
  }
  ~IncludeTest() override { std::filesystem::current_path(start_); }

  SceneSpec Load() {
    diagnostics_ = {};
    return LoadScene("s.txt", &diagnostics_);
  }
  SceneSpec LoadWell() {
    SceneSpec spec = Load();
    EXPECT_THAT(diagnostics_.Lines(), IsEmpty());
    return spec;
  }

  std::filesystem::path start_ = std::filesystem::current_path();
  testing_support::TempFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(IncludeTest, SectionsAreReadAsIfTheyStoodThere) {
  Put("s.txt", "include camera.txt include all.txt");
  Put("camera.txt", kCamera);
  Put("all.txt", "Materials { Material { name m } } Scene { }");
  const SceneSpec spec = LoadWell();
  ASSERT_TRUE(spec.camera.params.Find("center"));
  EXPECT_EQ(spec.camera.params.Find("center")->words[2].text, "5");
  ASSERT_EQ(spec.materials.size(), 1u);
  EXPECT_EQ(spec.materials[0].name, "m");
}

TEST_F(IncludeTest, ListsTakeBlocksFromFiles) {
  Put("s.txt", kCamera +
                   "Textures { include t.txt } Materials { include m.txt Material { name b } }"
                   "Scene { include n.txt Node { include n.txt } include empty.txt }");
  Put("t.txt", "Texture { name t type constant }");
  Put("m.txt", "Material { name a }");
  Put("n.txt", "Node { Component<Material> { name a } " + kSphere + " Node { } }");
  Put("empty.txt", "# nothing");
  const SceneSpec spec = LoadWell();
  EXPECT_EQ(spec.textures.size(), 1u);
  ASSERT_EQ(spec.materials.size(), 2u);
  EXPECT_EQ(spec.materials[1].name, "b");
  std::vector<uint32_t> parents;
  for (size_t i = 1; i < spec.nodes.size(); ++i) parents.push_back(spec.nodes[i].parent);
  EXPECT_THAT(parents, ElementsAre(0, 1, 0, 3, 4));
}

TEST_F(IncludeTest, PathsAreMeantFromTheFileInWhichTheyStand) {
  Put("s.txt", kCamera + "include parts/p.txt");
  Put("parts/p.txt",
      "Background { cube_map sky }"
      "include deep/q.txt Materials { Material { name m diffuse texture w } }");
  Put("parts/deep/q.txt",
      "Textures { Texture { name w type image file ../wood.png } }"
      "Scene { Component<Material> { index 0 } Component<Object> { type mesh obj_file a.obj } }");
  Put("parts/deep/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const SceneSpec spec = LoadWell();
  EXPECT_EQ(spec.background.cube_map, "parts/sky");
  EXPECT_NE(spec.meshes.at("parts/deep/a.obj"), nullptr);
  const Param* file = spec.textures[0].texture.params.Find("file");
  EXPECT_EQ(spec.PathInScene(file->words[0]), "parts/deep/../wood.png");
}

// The scene is reached by a link; its folder's parent is not the folder that holds the link.
TEST_F(IncludeTest, AnAbsoluteIncludeIsFoundFromALinkedFolder) {
  std::filesystem::create_directories(folder_ / "far/below");
  Put("parts/a.txt",
      "Component<Material> { index 0 } "
      "Component<Object> { type mesh obj_file a.obj }");
  Put("parts/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Put("far/below/s.txt", kCamera + "Materials { Material { } } Scene { include " +
                             (folder_ / "parts/a.txt").string() + " }");
  std::filesystem::create_directory_symlink("far/below", folder_ / "link");
  const SceneSpec spec = LoadScene(folder_ / "link/s.txt", &diagnostics_);
  EXPECT_THAT(diagnostics_.Lines(), IsEmpty());
  EXPECT_TRUE(spec.meshes.contains((folder_ / "parts/a.obj").string()));
}

TEST_F(IncludeTest, WhatIsIncludedIsAnInput) {
  Put("s.txt", kCamera + "include a.txt include a.txt Scene { include b.txt }");
  Put("a.txt", "");
  Put("b.txt", "Component<Material> { index 0 } Component<Object> { type mesh obj_file a.obj }");
  Put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(InputFiles(Load()), ElementsAre("s.txt", "a.txt", "b.txt", "a.obj"));
}

TEST_F(IncludeTest, MistakesNameTheFileInWhichTheyStand) {
  Put("s.txt",
      kCamera + "include parts/p.txt Scene { Component<Material> { index 0 }\n" + kSphere + "}");
  Put("parts/p.txt", "\nMaterials { Material { diffuse x } }");
  const SceneSpec spec = Load();
  CompileScene(spec, &diagnostics_);
  EXPECT_THAT(diagnostics_.Lines(),
              ElementsAre("parts/p.txt:2:32: error: 'diffuse' expects three numbers, found 'x'"));
}

TEST_F(IncludeTest, ObjectsOfOtherFilesAreDescribedWithTheFile) {
  Put("s.txt", kCamera + "Materials { Material { } }\nScene { Component<Material> { index 0 } " +
                   kSphere + " Node { include parts/p.txt } }");
  Put("parts/p.txt", "Component<Material> { index 0 }\n" + kSphere);
  const auto scene = CompileScene(LoadWell(), &diagnostics_);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->objects()[0].description, "sphere of line 3");
  EXPECT_EQ(scene->objects()[1].description, "sphere of parts/p.txt:2");
}

TEST_F(IncludeTest, ACircleIsNamedWhole) {
  Put("s.txt", kCamera + "include parts/a.txt Scene { }");
  Put("parts/a.txt", "include b.txt");
  Put("parts/b.txt", "include ../s.txt");
  Load();
  EXPECT_THAT(diagnostics_.Lines(),
              ElementsAre("parts/b.txt:1:9: error: the files include each other in a circle: s.txt "
                          "-> parts/a.txt -> parts/b.txt -> parts/../s.txt"));
}

TEST_F(IncludeTest, TheDepthIsLimited) {
  Put("s.txt", kCamera + "include 1.txt Scene { }");
  const size_t deepest = SceneText::kDeepest;
  for (size_t i = 1; i <= deepest; ++i) {
    Put(fmt::format("{}.txt", i), i == deepest ? "" : fmt::format("include {}.txt", i + 1));
  }
  LoadWell();
  Put(fmt::format("{}.txt", deepest), "include last.txt");
  Put("last.txt", "");
  Load();
  EXPECT_THAT(diagnostics_.Lines(),
              ElementsAre("64.txt:1:9: error: files include each other more than 64 deep"));
}

// Each of these files includes the next one twice: 2^40 files if nobody stopped it.
TEST_F(IncludeTest, TheNumberOfFilesIsLimited) {
  Put("s.txt", kCamera + "include 1.txt Scene { }");
  for (int i = 1; i <= 40; ++i) {
    Put(fmt::format("{}.txt", i),
        i == 40 ? "" : fmt::format("include {0}.txt include {0}.txt", i + 1));
  }
  Load();
  ASSERT_EQ(diagnostics_.ErrorCount(), 1u);
  EXPECT_THAT(diagnostics_.Lines()[0], HasSubstr("a scene can include at most 10000 files"));
}

// A file that ends too early takes nothing from those that go on behind it.
TEST_F(IncludeTest, AMissingBraceStaysInItsFile) {
  Put("s.txt", kCamera + "Scene { include n.txt Node { } }\nMaterials { Material { } }");
  Put("n.txt", "Node {\n Node { " + kSphere + "\n Component<Material> { index 0 }");
  const SceneSpec spec = Load();
  EXPECT_THAT(diagnostics_.Lines(),
              ElementsAre("n.txt:3:33: error: the file ends inside the block 'Node' of line 2"));
  EXPECT_EQ(spec.nodes.size(), 4u);
  EXPECT_EQ(spec.nodes[3].parent, 0u);
}

TEST_F(IncludeTest, ABraceTooManyClosesNothingElsewhere) {
  Put("s.txt", kCamera + "Scene { include n.txt Node { } }");
  Put("n.txt", "Node { } }");
  const SceneSpec spec = Load();
  EXPECT_THAT(diagnostics_.Lines(),
              ElementsAre("n.txt:1:10: warning: this closing brace closes nothing"));
  EXPECT_EQ(spec.nodes.size(), 3u);
}

}  // namespace
}  // namespace candela
