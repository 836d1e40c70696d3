#pragma once

#include <filesystem>
#include <vector>

#include "scene_spec/scene_spec.h"

namespace candela {

/// The files that a scene is made of: its own, its meshes, the pictures of its background and its
/// textures, and the photometric files of its lamps.
std::vector<std::filesystem::path> ContentFiles(const SceneSpec& spec);

/// These, and the ones that were read without an effect on the picture. None may be an output.
std::vector<std::filesystem::path> InputFiles(const SceneSpec& spec);

}  // namespace candela
