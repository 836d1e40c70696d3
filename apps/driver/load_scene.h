#pragma once

#include <filesystem>
#include <memory>

#include "base/result.h"
#include "scene/scene.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// A scene that was read and compiled without errors.
struct LoadedScene {
  SceneSpec spec;
  std::unique_ptr<Scene> scene;
  size_t warnings = 0;
  double load_seconds = 0;   ///< Reading the file and its meshes.
  double build_seconds = 0;  ///< Compiling.
};

/// Reads and compiles a scene and prints its errors and warnings on stderr. When there are errors,
/// the one that is returned has no message: all has been said.
Result<LoadedScene> LoadSceneForUser(const std::filesystem::path& path);

}  // namespace candela
