#pragma once

#include "math/vec.h"

namespace candela {

/// A point that asks for light.
struct Receiver {
  Receiver() = default;
  // A point that takes light from all around may stand for itself.
  Receiver(Vec3 point, Vec3 normal = {}) : p(point), n(normal) {}

  Vec3 p;
  Vec3 n{};  ///< Unless 0, light counts by the cosine to this unit vector, and from behind not.
};

}  // namespace candela
