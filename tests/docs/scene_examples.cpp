#include "tests/docs/scene_examples.h"

#include <fmt/format.h>

#include "tests/docs/markdown.h"

namespace candela::docs {
namespace {

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

}  // namespace

std::vector<SceneExample> SceneExamples() {
  const std::vector<FencedBlock> blocks = FencedBlocks(ReadDocument("docs/scene-format.md"));
  std::vector<SceneExample> examples;
  for (size_t i = 0; i < blocks.size(); ++i) {
    const std::string scene = SceneOf(blocks[i]);
    if (scene.empty() || blocks[i].Argument() == "included") continue;
    const bool is_wrong = blocks[i].Argument() == "wrong";
    examples.push_back({scene, blocks[i].line, is_wrong, is_wrong ? blocks[i + 1].text : ""});
  }
  return examples;
}

}  // namespace candela::docs
