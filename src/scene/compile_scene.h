#pragma once

#include <memory>

#include "base/diagnostics.h"
#include "kernel/accelerator_kind.h"
#include "scene/scene.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// What a scene is compiled for.
struct CompileOptions {
  /// What finds the hits; all kinds find the same.
  AcceleratorKind accelerator = AcceleratorKind::kBvh;
  /// Where it is not null, it gets the description with the parameters that it leaves to defaults,
  /// for the same scene.
  SceneSpec* resolved = nullptr;
};

/// Builds what a description says: objects from the registries, transforms, textures, the search
/// tree. What is wrong goes to `diagnostics`; null when it holds errors, also from loading. Of a
/// description with errors it finds the further ones, so that one run shows them all.
std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics,
                                    const CompileOptions& options = {});

}  // namespace candela
