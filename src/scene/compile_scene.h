#pragma once

#include <memory>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Builds what a description says: objects from the registries, transforms, textures, the search
/// tree. What is wrong goes to `diagnostics`; null when there are errors.
std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics);

}  // namespace candela
