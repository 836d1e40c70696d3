#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/files.h"
#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"
#include "scene/input_files.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing_support::Put;
using testing_support::TempFolder;

const std::string kCamera = "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n";
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string MeshNode(const std::string& path) {
  return "Node { Component<Material> { index 0 } Component<Object> { type mesh obj_file " + path +
         " } }\n";
}

TEST(LoadScene, FilesOfOneMeshAreReadOnceHoweverTheyAreSpelt) {
  const TempFolder folder;
  Put(folder / "a.obj", kTriangle);
  std::filesystem::create_symlink("a.obj", folder / "link.obj");
  Put(folder / "s.txt", kCamera + "Materials { Material { } } Scene { " + MeshNode("a.obj") +
                            MeshNode("./a.obj") + MeshNode("a.obj") + MeshNode("link.obj") + "}");
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(folder / "s.txt", &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  ASSERT_EQ(spec.meshes.size(), 3u);
  EXPECT_NE(spec.meshes.at("a.obj"), nullptr);
  EXPECT_EQ(spec.meshes.at("a.obj"), spec.meshes.at("./a.obj"));
  EXPECT_EQ(spec.meshes.at("a.obj"), spec.meshes.at("link.obj"));
  EXPECT_THAT(spec.files, ElementsAre(folder / "s.txt", folder / "a.obj"));
}

TEST(LoadScene, ABrokenMeshIsReportedOnce) {
  const TempFolder folder;
  Put(folder / "a.obj", "v 0 0\nf 1 1 1\n");
  Put(folder / "s.txt", kCamera + "Materials { Material { } } Scene { " + MeshNode("a.obj") +
                            MeshNode("./a.obj") + "}");
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(folder / "s.txt", &diagnostics);
  EXPECT_EQ(CompileScene(spec, &diagnostics), nullptr);
  EXPECT_EQ(diagnostics.ErrorCount(), 1u);
}

TEST(LoadScene, InputFilesAreAllThatMustNotBeOverwritten) {
  const TempFolder folder;
  Put(folder / "a.obj", "mtllib a.mtl none.mtl\n" + kTriangle);
  Put(folder / "a.mtl", "newmtl red\n");
  Put(folder / "s.txt", "Background { cube_map sky }" + kCamera +
                            "Materials { Material { } } Scene { " + MeshNode("a.obj") +
                            "Node { Component<Light> { type ies file l.ies } } }" +
                            "Textures { Texture { name w type image file w.png } }");
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(folder / "s.txt", &diagnostics);
  const auto sky = folder / "sky";
  std::vector<std::filesystem::path> files = {
      folder / "s.txt", folder / "a.obj",  sky / "left.png", sky / "right.png", sky / "up.png",
      sky / "down.png", sky / "front.png", sky / "back.png", folder / "w.png",  folder / "l.ies"};
  EXPECT_EQ(ContentFiles(spec), files);
  files.push_back(folder / "a.mtl");
  EXPECT_EQ(InputFiles(spec), files);
}

TEST(LoadScene, TheScenesOfTheProjectAreSound) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("assets/assignment4")) {
    if (entry.path().extension() != ".txt") continue;
    ++count;
    SCOPED_TRACE(entry.path());
    Diagnostics diagnostics;
    const SceneSpec spec = LoadScene(entry.path(), &diagnostics);
    const auto scene = CompileScene(spec, &diagnostics);
    EXPECT_THAT(diagnostics.Lines(), IsEmpty());
    ASSERT_NE(scene, nullptr);
    EXPECT_FALSE(scene->objects().empty());
  }
  EXPECT_GE(count, 7);
}

TEST(LoadScene, WhatIsNoRegularFileIsNamedAsWhatItIs) {
  const TempFolder folder;
  ::mkfifo((folder / "pipe").c_str(), 0600);
  const auto lines_of = [](const std::filesystem::path& path) {
    Diagnostics diagnostics;
    const SceneSpec spec = LoadScene(path, &diagnostics);
    EXPECT_EQ(CompileScene(spec, &diagnostics), nullptr);
    return diagnostics.Lines();
  };
  const std::string name = folder.path().string();
  EXPECT_THAT(lines_of(folder.path()), ElementsAre(name + ": error: is a folder, not a file"));
  EXPECT_THAT(lines_of(folder / "pipe"), ElementsAre(name + "/pipe: error: is a pipe, not a file"));
  EXPECT_THAT(lines_of("/dev/null"), ElementsAre("/dev/null: error: is a device, not a file"));
  EXPECT_THAT(lines_of(folder / "none"), ElementsAre(name + "/none: error: no such file"));
}

}  // namespace
}  // namespace candela
