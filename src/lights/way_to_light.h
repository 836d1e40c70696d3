#pragma once

#include <cmath>

#include "math/vec.h"

namespace candela {

/// The straight way from a point to a light that is in one place.
struct WayToLight {
  WayToLight(Vec3 from, Vec3 to) {
    offset = to - from;
    squared = Dot(offset, offset);
    distance = std::sqrt(squared);
  }

  /// In the light itself there is no direction to it.
  bool IsNone() const { return squared == 0; }

  /// As a unit vector. Made where it is wanted: a copy of what has just been stored in parts waits.
  Vec3 Direction() const { return offset / distance; }

  Vec3 offset;
  float distance, squared;  ///< How far it is, and the square of that.
};

}  // namespace candela
