#pragma once

#include <cmath>

#include "geometry/ray.h"
#include "geometry/surface_point.h"

namespace candela {

/// A ray that leaves a surface towards the unit direction `w`. It starts beside the surface by the
/// error bound of the hit, so that it cannot hit the same spot again, whatever the scale of the
/// scene: Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd edition, section 3.9.5,
/// 2016.
inline Ray SpawnRay(const SurfacePoint& point, Vec3 w) {
  // The error box, seen along the normal.
  const float distance = Dot(Abs(point.n_geometric), point.p_error);
  const Vec3 n = Dot(point.n_geometric, w) < 0 ? -point.n_geometric : point.n_geometric;
  Vec3 origin = point.p + n * distance;
  // The sum was rounded: make sure that it was not rounded back towards the surface.
  for (int axis = 0; axis < 3; ++axis) {
    if (n[axis] == 0) continue;
    origin[axis] = std::nextafter(origin[axis], n[axis] > 0 ? INFINITY : -INFINITY);
  }
  return {origin, w};
}

}  // namespace candela
