// The examples of the manual of the scene format are what the parser takes, and it leaves out
// nothing that scenes may name.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
#include "textures/registry.h"

namespace candela::docs {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kManual = "docs/scene-format.md";
// The examples name meshes and a cube map that ship with the project.
constexpr const char* kFolder = "assets/assignment4";

constexpr const char* kCamera = "Camera { center 0 0 10  direction 0 0 -1  up 0 1 0  fov 30 }\n";
constexpr const char* kMaterials = "Materials { Material { diffuse 1 1 1 } }\n";

/// The whole scene that an example stands for; empty for blocks that are no scene.
std::string SceneOf(const FencedBlock& block) {
  const std::string kind = block.Language();
  if (kind == "scene") return block.text;
  if (kind == "node") return fmt::format("{}{}Scene {{\n{}}}\n", kCamera, kMaterials, block.text);
  if (kind == "section") {
    return block.text.starts_with("Camera") ? block.text + "Scene {}"
                                            : kCamera + block.text + "Scene {}";
  }
  return {};
}

std::vector<std::string> LinesAbout(const std::string& scene) {
  Diagnostics diagnostics;
  const auto name = std::make_shared<const std::string>("scene.txt");
  const SceneSpec spec = ParseScene(name, scene, kFolder, &diagnostics);
  if (!diagnostics.HasErrors()) CompileScene(spec, &diagnostics);
  return diagnostics.Lines();
}

TEST(SceneFormat, ExamplesCompileWithoutAWord) {
  size_t count = 0;
  for (const FencedBlock& block : FencedBlocks(ReadDocument(kManual))) {
    const std::string scene = SceneOf(block);
    if (scene.empty() || block.Argument() == "wrong") continue;
    SCOPED_TRACE(fmt::format("{}:{}", kManual, block.line));
    EXPECT_THAT(LinesAbout(scene), IsEmpty());
    ++count;
  }
  EXPECT_GE(count, 14u);
}

// A wrong scene is followed by a block with what is said about it.
TEST(SceneFormat, MessagesAreThoseOfTheParser) {
  const std::vector<FencedBlock> blocks = FencedBlocks(ReadDocument(kManual));
  size_t count = 0;
  for (size_t i = 0; i + 1 < blocks.size(); ++i) {
    if (blocks[i].Argument() != "wrong") continue;
    EXPECT_EQ(fmt::format("{}\n", fmt::join(LinesAbout(blocks[i].text), "\n")), blocks[i + 1].text);
    ++count;
  }
  EXPECT_EQ(count, 1u);
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
