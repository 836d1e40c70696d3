#include "driver/load_scene.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/clock.h"
#include "base/diagnostics.h"
#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"

namespace candela {

std::optional<LoadedScene> LoadSceneForUser(const std::filesystem::path& path) {
  LoadedScene loaded;
  Diagnostics diagnostics;
  const Stopwatch load_clock;
  loaded.spec = LoadScene(path, &diagnostics);
  loaded.load_seconds = load_clock.Seconds();
  if (!diagnostics.HasErrors()) {
    const Stopwatch build_clock;
    loaded.scene = CompileScene(loaded.spec, &diagnostics);
    loaded.build_seconds = build_clock.Seconds();
  }
  for (const std::string& line : diagnostics.Lines()) fmt::print(stderr, "{}\n", line);
  if (!loaded.scene) return std::nullopt;
  loaded.warnings = diagnostics.WarningCount();
  return loaded;
}

std::vector<std::filesystem::path> FilesOf(const SceneSpec& spec) {
  std::vector<std::filesystem::path> files;
  for (const auto& [path, mesh] : spec.meshes) files.push_back(spec.folder / path);
  if (!spec.background.cube_map.empty()) {
    for (auto& face : CubeMap::FaceFiles(spec.folder / spec.background.cube_map)) {
      files.push_back(std::move(face));
    }
  }
  return files;
}

}  // namespace candela
