#pragma once

#include <cstdint>
#include <string>

#include "scene_spec/scene_spec.h"

namespace candela::determinism {

/// A scene, given as text, with random meshes in it, which wear its first materials: one that
/// stands there once, a small one that several nodes have, and a large one that several nodes have;
/// with and without normals of their own, turned, stretched, mirrored. The same for the same seed,
/// everywhere.
SceneSpec RandomMeshScene(uint32_t seed, const std::string& rest);

/// Makes the objects that do not shine move, turn and grow, each third of them in three steps, and
/// the camera go along.
void SetInMotion(uint32_t seed, SceneSpec* spec);

}  // namespace candela::determinism
