// The examples of the manual of the scene format are what the parser takes, and it leaves out
// nothing that scenes may name.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "integrators/registry.h"
#include "lights/registry.h"
#include "loaders/course/scene_parser.h"
#include "materials/registry.h"
#include "scene/compile_scene.h"
#include "shapes/registry.h"
#include "tests/docs/markdown.h"
#include "tests/docs/scene_examples.h"
#include "tests/support/program.h"
#include "tests/support/temp_folder.h"
#include "textures/registry.h"

namespace candela::docs {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kManual = "docs/scene-format.md";

std::vector<std::string> LinesAbout(const std::string& scene) {
  Diagnostics diagnostics;
  const auto name = std::make_shared<const std::string>("scene.txt");
  const SceneSpec spec = ParseScene(name, scene, kExampleFolder, &diagnostics);
  if (!diagnostics.HasErrors()) CompileScene(spec, &diagnostics);
  return diagnostics.Lines();
}

TEST(SceneFormat, ExamplesCompileWithoutAWord) {
  size_t count = 0;
  for (const SceneExample& example : SceneExamples()) {
    if (example.is_wrong) continue;
    SCOPED_TRACE(fmt::format("{}:{}", kManual, example.line));
    EXPECT_THAT(LinesAbout(example.text), IsEmpty());
    ++count;
  }
  EXPECT_GE(count, 14u);
}

// A wrong scene is followed by a block with what is said about it.
TEST(SceneFormat, MessagesAreThoseOfTheParser) {
  size_t count = 0;
  for (const SceneExample& example : SceneExamples()) {
    if (!example.is_wrong) continue;
    EXPECT_EQ(fmt::format("{}\n", fmt::join(LinesAbout(example.text), "\n")), example.messages);
    ++count;
  }
  EXPECT_EQ(count, 1u);
}

// What the program knows and the parser does not.
TEST(SceneFormat, SettingsAreThoseOfTheProgram) {
  const testing_support::TempFolder folder;
  size_t count = 0;
  for (const SceneExample& example : SceneExamples()) {
    if (example.text.find("Render {") == std::string::npos) continue;
    testing_support::Put(folder / "scene.txt", example.text);
    const auto end =
        testing_support::RunProgram(CANDELA_PROGRAM, {"check", (folder / "scene.txt").string()});
    EXPECT_EQ(end.err, "") << kManual << ":" << example.line;
    EXPECT_EQ(end.status, 0);
    ++count;
  }
  EXPECT_GE(count, 1u);
}

TEST(SceneFormat, TheExampleOfSeveralFilesIsAScene) {
  const testing_support::TempFolder folder;
  std::filesystem::create_directory(folder / "parts");
  for (const FencedBlock& block : FencedBlocks(ReadDocument(kManual))) {
    if (block.Language() == "part") testing_support::Put(folder / block.Argument(), block.text);
    if (block.Argument() == "included") testing_support::Put(folder / "scene.txt", block.text);
  }
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(folder / "scene.txt", &diagnostics);
  CompileScene(spec, &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  EXPECT_EQ(spec.files.size(), 3u);
}

TEST(SceneFormat, EverythingThatScenesMayNameHasItsHeadline) {
  const std::string manual = ReadDocument(kManual);
  for (const auto& entry : ShapeEntries()) {
    EXPECT_THAT(manual, HasSubstr(fmt::format("\n### `{}`\n", entry.name)));
  }
  for (const auto& entry : LightEntries()) {
    EXPECT_THAT(manual, HasSubstr(fmt::format("\n### `{}`\n", entry.name)));
  }
  for (const auto& entry : MaterialEntries()) {
    EXPECT_THAT(manual, HasSubstr(fmt::format("\n### `{}`\n", entry.name)));
  }
  for (const auto& entry : TextureEntries()) {
    EXPECT_THAT(manual, HasSubstr(fmt::format("\n### `{}`\n", entry.name)));
  }
  for (const auto& entry : IntegratorEntries()) {
    EXPECT_THAT(manual, HasSubstr(fmt::format("`{}`", entry.name)));
  }
}

}  // namespace
}  // namespace candela::docs
