#pragma once

#include <bit>
#include <cstdint>

#include "geometry/ray.h"
#include "geometry/surface_point.h"

namespace candela {

/// The next float in the direction of the sign of `toward`; `x` is finite. What `std::nextafter`
/// says, without the call and the cases that do not come up here.
inline float NextFloat(float x, float toward) {
  if (x == 0) return toward > 0 ? 0x1p-149f : -0x1p-149f;
  const auto bits = std::bit_cast<uint32_t>(x);
  return std::bit_cast<float>((x > 0) == (toward > 0) ? bits + 1 : bits - 1);
}

/// A ray that leaves a surface towards the unit direction `w`. It starts beside the surface by the
/// error bound of the hit, so that it cannot hit the same spot again, whatever the scale of the
/// scene, on the side of the surface that the direction `side` is on: Pharr, Jakob and Humphreys,
/// "Physically Based Rendering", 3rd edition, section 3.9.5, 2016.
inline Ray SpawnRay(const SurfacePoint& point, Vec3 w, Vec3 side) {
  // The error box, seen along the normal.
  const float distance = Dot(Abs(point.n_geometric), point.p_error);
  const Vec3 n = Dot(point.n_geometric, side) < 0 ? -point.n_geometric : point.n_geometric;
  Vec3 origin = point.p + n * distance;
  // The sum was rounded: make sure that it was not rounded back towards the surface.
  for (int axis = 0; axis < 3; ++axis) {
    if (n[axis] != 0) origin[axis] = NextFloat(origin[axis], n[axis]);
  }
  return {origin, w};
}
/// On the side to which it goes.
inline Ray SpawnRay(const SurfacePoint& point, Vec3 w) {
  return SpawnRay(point, w, w);
}

}  // namespace candela
