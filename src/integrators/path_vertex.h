#pragma once

#include <cstdint>
#include <span>

#include "geometry/ray.h"
#include "geometry/spawn_ray.h"
#include "geometry/surface_point.h"
#include "integrators/integrator.h"
#include "integrators/medium_stack.h"
#include "lights/receiver.h"
#include "materials/bsdf.h"
#include "materials/material.h"
#include "math/vec.h"
#include "scene/interior.h"

namespace candela {

/// A surface that a path has met.
struct PathVertex {
  PathVertex(const Scene& scene, const Ray& ray, const HitRecord& hit)
      : point(scene.SurfaceAt(ray, hit)), wo(-Normalize(ray.direction)), time(ray.time) {}
  PathVertex(const SurfacePoint& surface_point, Vec3 w) : point(surface_point), wo(w) {}

  SurfacePoint point;
  Vec3 wo;  ///< Unit vector to where the path comes from.
  Bsdf bsdf;
  const Material* material;
  bool is_lifted = false;    ///< See `Scene::LiftOf`.
  float time = 0;            ///< Of the path.
  MediumStack media_beyond;  ///< What light is in that goes through into a body, or out of it.

  /// For the choice of a light, once it is evaluated.
  Receiver AsReceiver() const { return {point.p, bsdf.IsOpaque() ? bsdf.frame.z : Vec3()}; }

  /// Finds out what the surface does with light, once all else is known.
  void Evaluate();
};

/// Sets what there is on both sides of the surface of a body, for light that is in the media
/// `here`; false when the surface lies hidden in another body. Counts what had to be left out.
bool FindMedia(std::span<const Interior> interiors, uint32_t interior, const MediumStack& here,
               RayCounts* rays, PathVertex* vertex);

/// Whether light that goes through stays on one side of the true surface, or light that is
/// reflected goes through it. Where a shading normal says otherwise, light would leak.
inline bool IsOnWrongSide(const PathVertex& vertex, Vec3 wi, bool is_transmission) {
  const Vec3 n = vertex.point.n_geometric;
  const bool is_one_side = Dot(n, vertex.wo) * Dot(n, wi) > 0;
  // A lifted point is high enough for its own triangle to be in the way of what would leak.
  if (vertex.is_lifted && !is_transmission) return false;
  return is_one_side == is_transmission;
}

inline Ray LeavingRay(const PathVertex& vertex, Vec3 w) {
  Ray ray = SpawnRay(vertex.point, w, vertex.is_lifted ? vertex.wo : w);
  ray.time = vertex.time;
  return ray;
}

/// The ray that goes on as if the surface were not there.
inline Ray PassOn(const PathVertex& vertex) {
  Ray ray = SpawnRay(vertex.point, -vertex.wo);
  ray.time = vertex.time;
  ray.mask = kReflectionRay;
  return ray;
}

}  // namespace candela
