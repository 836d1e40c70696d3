// The course's own scenes, where they are installed beside the project.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"
#include "tests/support/course_folder.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

const char* const kScenes[] = {"scene01_plane", "scene02_cube",      "scene03_sphere",
                               "scene04_axes",  "scene05_bunny_200", "scene06_bunny_1k",
                               "scene07_arch"};

/// Loads and compiles without an error or a warning, and has something in it.
void ExpectSound(const fs::path& path) {
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(path, &diagnostics);
  const auto scene = CompileScene(spec, &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), testing::IsEmpty());
  ASSERT_NE(scene, nullptr);
  EXPECT_FALSE(scene->objects().empty());
  EXPECT_FALSE(scene->lights().empty());
}

TEST(CourseScenes, ParseUnchangedWithoutWarnings) {
  const fs::path assets = testing_support::CourseFolder() / "assets";
  if (!fs::exists(assets)) GTEST_SKIP() << "not run: there is no folder " << assets;
  for (const char* name : kScenes) {
    SCOPED_TRACE(name);
    ExpectSound(assets / (std::string(name) + ".txt"));
  }
}

}  // namespace
}  // namespace candela
