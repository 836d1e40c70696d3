#pragma once

#include <cmath>

#include "math/vec.h"

namespace candela {

/// The straight way from a point to a light that is in one place.
struct WayToLight {
  WayToLight(Vec3 from, Vec3 to) {
    const Vec3 way = to - from;
    squared = Dot(way, way);
    distance = std::sqrt(squared);
    direction = way / distance;
  }

  /// In the light itself there is no direction to it.
  bool IsNone() const { return squared == 0; }

  Vec3 direction;           ///< A unit vector.
  float distance, squared;  ///< How far it is, and the square of that.
};

}  // namespace candela
