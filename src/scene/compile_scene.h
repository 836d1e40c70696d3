#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// The files that a scene is made of: its own, its meshes, and the pictures of its background and
/// its textures.
std::vector<std::filesystem::path> ContentFiles(const SceneSpec& spec);

/// These, and the ones that were read without an effect on the picture. None may be an output.
std::vector<std::filesystem::path> InputFiles(const SceneSpec& spec);

/// Builds what a description says: objects from the registries, transforms, textures, the search
/// tree. What is wrong goes to `diagnostics`; null when it holds errors, also from loading. Of a
/// description with errors it finds the further ones, so that one run shows them all. `resolved`,
/// where it is not null, gets the description with the parameters that it leaves to defaults, for
/// the same scene.
std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics,
                                    SceneSpec* resolved = nullptr);

}  // namespace candela
