#pragma once

#include "geometry/bounds3.h"

namespace candela {

/// A ball; that of radius 0 holds nothing.
struct Ball {
  Vec3 center{};
  float radius = 0;
};

/// The one around the corners of a finite box, a little larger than that.
inline Ball BallAround(const Bounds3& bounds) {
  if (bounds.IsEmpty()) return {};
  const Vec3 corner = Max(Abs(bounds.min), Abs(bounds.max));
  const float rounding = 1e-6f * std::max({corner.x, corner.y, corner.z});
  return {bounds.Center(), Length(bounds.Extent()) * 0.5001f + rounding};
}

}  // namespace candela
