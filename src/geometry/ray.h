#pragma once

#include <limits>

#include "math/vec.h"

namespace candela {

/// The part t_min <= t < t_max of the half-line o + t d. The direction is not normalised when a ray
/// is taken to object space, so t means the same everywhere.
struct Ray {
  Vec3 origin;
  float t_min = 0;  ///< Not negative.
  Vec3 direction;
  float t_max = std::numeric_limits<float>::max();  ///< Hits have t < t_max.

  Ray() = default;
  Ray(Vec3 ray_origin, Vec3 ray_direction) : origin(ray_origin), direction(ray_direction) {}

  Vec3 At(float t) const { return origin + direction * t; }
};

}  // namespace candela
