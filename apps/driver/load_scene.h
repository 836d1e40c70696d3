#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/compile_scene.h"
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

/// What a program makes of the settings in a scene, before it is compiled, and how that is done.
/// What is wrong with them goes to the diagnostics; an error concerns the command line.
using SettingsReader =
    std::function<Result<CompileOptions>(const SceneSpec& spec, Diagnostics* diagnostics)>;

/// What else has to hold for a scene that was compiled.
using SceneCheck = std::function<void(const Scene& scene, Diagnostics* diagnostics)>;

/// Reads and compiles a scene and prints its errors and warnings on stderr. When there are errors,
/// the one that is returned has no message: all has been said. One of `read_settings` has.
/// `check`, where there is one, is asked about a scene that is sound otherwise.
Result<LoadedScene> LoadSceneForUser(const std::filesystem::path& path,
                                     const SettingsReader& read_settings, const SceneCheck& check);

}  // namespace candela
