#pragma once

#include <cmath>

#include "math/elementary.h"
#include "math/vec.h"

namespace candela {

// All directions as the unit square: pictures of the surroundings in which columns are longitudes
// and rows latitudes. The middle is the direction -z, the upper edge +y; x grows to the right, so
// that +x is at three quarters.

/// The place of a unit direction, in [0, 1]^2, y downwards from the zenith.
inline Vec2 LatLongOf(Vec3 direction) {
  constexpr auto kInverseTurn = static_cast<float>(1 / (2 * kPi));
  constexpr auto kInversePi = static_cast<float>(1 / kPi);
  // Not the arc cosine of y, which has no digits left near the poles.
  const float level = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  const float x = 0.5f + Atan2(direction.x, -direction.z) * kInverseTurn;
  const float y = Atan2(level, direction.y) * kInversePi;
  return {x, y};
}

/// The unit direction of a place.
inline Vec3 DirectionOfLatLong(Vec2 place) {
  const auto [sin_x, cos_x] = SinCos((place.x - 0.5f) * static_cast<float>(2 * kPi));
  const auto [sin_y, cos_y] = SinCos(place.y * static_cast<float>(kPi));
  return ToFloat(Vec3d{sin_x * sin_y, cos_y, -cos_x * sin_y});
}

/// A place moved to the right by a part of a turn, back into [0, 1).
inline Vec2 TurnLatLong(Vec2 place, float turn) {
  const float x = place.x + turn;
  const float wrapped = x - std::floor(x);
  return {wrapped < 1 ? wrapped : 0, place.y};
}

}  // namespace candela
