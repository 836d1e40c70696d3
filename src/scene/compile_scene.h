#pragma once

#include <memory>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Builds what a description says: objects from the registries, transforms, textures, the search
/// tree. What is wrong goes to `diagnostics`; null when it holds errors, also from loading. Of a
/// description with errors it finds the further ones, so that one run shows them all. `resolved`,
/// where it is not null, gets the description with the parameters that it leaves to defaults, for
/// the same scene.
std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics,
                                    SceneSpec* resolved = nullptr);

}  // namespace candela
