#pragma once

#include "base/diagnostics.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Reads the mesh files that the nodes of a scene name, relative to its folder, each of them once,
/// into `spec->meshes` and `spec->files`. What is wrong is reported at the first node that asks, or
/// under the name of the file.
void LoadMeshes(SceneSpec* spec, Diagnostics* diagnostics);

}  // namespace candela
