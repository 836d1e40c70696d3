#pragma once

#include <limits>

#include "math/vec.h"

namespace candela {

/// The half-line o + t d for t_min <= t, together with the largest t of interest. The direction is
/// not normalised when a ray is taken to object space, so t means the same everywhere.
struct Ray {
  Vec3 origin;
  float t_min = 0;
  Vec3 direction;
  float t_max = std::numeric_limits<float>::max();  ///< Hits have t < t_max.

  Ray() = default;
  Ray(Vec3 ray_origin, Vec3 ray_direction) : origin(ray_origin), direction(ray_direction) {}

  Vec3 At(float t) const { return origin + direction * t; }
};

}  // namespace candela
