#pragma once

#include <bit>
#include <cstdint>

#include "geometry/ray.h"
#include "geometry/surface_point.h"

namespace candela {

/// The next float in the direction of the sign of `toward`, which is not NaN; `x` itself when that
/// is 0. `x` is finite. What `std::nextafter` says, without the call and without branches: nobody
/// can guess the signs.
inline float NextFloat(float x, float toward) {
  const auto bits = std::bit_cast<uint32_t>(x), direction = std::bit_cast<uint32_t>(toward);
  // All ones where they hold: compilers make branches of conditions, but not of these.
  const auto if_set = [](uint32_t bit) { return 0 - bit; };
  const uint32_t is_zero = if_set(uint32_t{x == 0}), stays = if_set(uint32_t{toward == 0});
  const uint32_t is_shorter = (bits ^ direction) >> 31;
  const uint32_t next = bits + 1 - 2 * is_shorter, beside_zero = (direction & 0x80000000) | 1;
  const uint32_t moved = (next & ~is_zero) | (beside_zero & is_zero);
  return std::bit_cast<float>((moved & ~stays) | (bits & stays));
}

/// A ray that leaves a surface towards the unit direction `w`. It starts beside the surface by the
/// error bound of the hit, so that it cannot hit the same spot again, whatever the scale of the
/// scene, on the side of the surface that the direction `side` is on: Pharr, Jakob and Humphreys,
/// "Physically Based Rendering", 3rd edition, section 3.9.5, 2016.
inline Ray SpawnRay(const SurfacePoint& point, Vec3 w, Vec3 side) {
  // The error box, seen along the normal.
  const float distance = Dot(Abs(point.n_geometric), point.p_error);
  const Vec3 n = Dot(point.n_geometric, side) < 0 ? -point.n_geometric : point.n_geometric;
  const Vec3 origin = point.p + n * distance;
  // The sum was rounded: make sure that it was not rounded back towards the surface.
  return {{NextFloat(origin.x, n.x), NextFloat(origin.y, n.y), NextFloat(origin.z, n.z)}, w};
}
/// On the side to which it goes.
inline Ray SpawnRay(const SurfacePoint& point, Vec3 w) {
  return SpawnRay(point, w, w);
}

}  // namespace candela
