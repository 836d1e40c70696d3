#pragma once

#include <cstdint>

#include "scene_spec/scene_spec.h"

namespace candela::determinism {

/// A random scene (see `RandomScene` and `RandomDiffuseScene`) with meshes in it: one that stands
/// there once, a small one that several nodes have, and a large one that several nodes have; with
/// and without normals of their own, turned, stretched, mirrored. The same for the same seed,
/// everywhere.
SceneSpec RandomMeshScene(uint32_t seed, bool is_diffuse);

}  // namespace candela::determinism
