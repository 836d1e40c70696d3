#pragma once

#include "math/transform.h"

namespace candela {

/// What a light may ask for while it is created.
struct LightContext {
  Transform world_from_node;
  bool has_object;  ///< Whether its node has an object, whose surface can shine.
};

}  // namespace candela
