#pragma once

#include "math/transform.h"
#include "scene_spec/param_set.h"

namespace candela {

/// What a light may ask for while it is created.
struct LightContext {
  Transform world_from_node;
  bool has_object;  ///< Whether its node has an object, whose surface can shine.
  /// Gets the parameters of the light, those included that are not given; may be null.
  ParamSet* resolved = nullptr;
};

}  // namespace candela
