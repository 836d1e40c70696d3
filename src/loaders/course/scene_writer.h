#pragma once

#include <string>

#include "scene_spec/scene_spec.h"

namespace candela {

/// A description as a scene text, which `ParseScene` makes the same description of when it lies in
/// the same folder: what was included stands in place, transforms are matrices, and numbers have
/// the fewest digits that give them back. Meshes, textures and pictures stay files of their own.
std::string WriteScene(const SceneSpec& spec);

}  // namespace candela
