#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Reads a scene text in the format of docs/scene-format.md. Meshes are loaded relative to
/// `folder`. What is wrong goes to `diagnostics`; when it holds errors the result is incomplete and
/// only good for finding more of them. Nested nodes cost no stack.
SceneSpec ParseScene(std::shared_ptr<const std::string> file, std::string_view text,
                     const std::filesystem::path& folder, Diagnostics* diagnostics);

/// The same for the file `path`; one that cannot be read is an error of its own.
SceneSpec LoadScene(const std::filesystem::path& path, Diagnostics* diagnostics);

}  // namespace candela
