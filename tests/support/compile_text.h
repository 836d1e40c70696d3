#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"

namespace candela::testing_support {

/// Compiles a scene text as if it stood in `folder`. Errors and warnings fail the test; then the
/// result may be null.
inline std::unique_ptr<const Scene> CompileText(std::string_view text,
                                                const std::filesystem::path& folder = ".") {
  Diagnostics diagnostics;
  const auto file = std::make_shared<const std::string>("scene");
  const SceneSpec spec = ParseScene(file, text, folder, &diagnostics);
  auto scene = CompileScene(spec, &diagnostics);
  for (const std::string& line : diagnostics.Lines()) ADD_FAILURE() << line << "\nin: " << text;
  return scene;
}

/// A camera in the origin that looks along -z and sees 90 degrees, so that the image point (x, y)
/// is the direction (x, y, -1).
inline constexpr const char* kCamera = "Camera { center 0 0 0 direction 0 0 -1 up 0 1 0 fov 90 }\n";

}  // namespace candela::testing_support
