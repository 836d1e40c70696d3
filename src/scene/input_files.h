#pragma once

#include <filesystem>
#include <vector>

#include "scene_spec/scene_spec.h"

namespace candela {

/// The files that a scene is made of: its own, its meshes, and the pictures of its background and
/// its textures.
std::vector<std::filesystem::path> ContentFiles(const SceneSpec& spec);

/// These, and the ones that were read without an effect on the picture. None may be an output.
std::vector<std::filesystem::path> InputFiles(const SceneSpec& spec);

}  // namespace candela
