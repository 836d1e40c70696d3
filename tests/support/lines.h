#pragma once

#include "geometry/spawn_ray.h"
#include "math/frame.h"
#include "sampling/warp.h"
#include "scene/scene.h"

namespace candela::testing_support {

/// What a straight line meets on its way through a scene.
struct Crossings {
  int count = 0;
  bool alternates = true;  ///< In, out, in, out: by normals that point outwards.
  double inside = 0;       ///< The length of the line between entries and exits.
};

inline Crossings FollowLine(const Scene& scene, Vec3 origin, Vec3 w) {
  Crossings crossings;
  Ray ray(origin, w);
  for (HitRecord hit; scene.Intersect(ray, &hit); hit = HitRecord()) {
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const bool enters = Dot(point.n_geometric, w) < 0;
    crossings.alternates = crossings.alternates && enters == (crossings.count % 2 == 0);
    const double along = static_cast<double>(Dot(point.p - origin, w));
    crossings.inside += enters ? -along : along;
    ++crossings.count;
    ray = SpawnRay(point, w);
  }
  crossings.alternates = crossings.alternates && crossings.count % 2 == 0;
  return crossings;
}

/// A line through a ball, all of which are equally likely for evenly spread numbers: of all lines
/// of a direction those through a disk across it, as large as the ball.
inline Ray LineThroughBall(Vec3 center, float radius, Vec2 u_direction, Vec2 u_place) {
  const Vec3 w = SampleUniformSphere(u_direction);
  const Vec2 across = SampleDisk(u_place);
  return {center + Frame::FromNormal(w).ToWorld({across.x, across.y, -1.5f}) * radius, w};
}

}  // namespace candela::testing_support
