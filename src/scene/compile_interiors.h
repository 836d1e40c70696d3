#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "scene/interior.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// What fills the objects of a scene, as far as that says so.
struct CompiledInteriors {
  /// By node. Nothing where the scene says nothing, or something wrong, which is reported.
  std::vector<std::optional<Interior>> of_node;
  /// What may meet at a surface, air among it; of media that refract alike only one. None when no
  /// object is filled.
  std::vector<Medium> media;
};

/// `resolved`, where it is not null, is a copy of the description that gets all parameters.
CompiledInteriors CompileInteriors(const SceneSpec& spec, Diagnostics* diagnostics,
                                   SceneSpec* resolved);

}  // namespace candela
