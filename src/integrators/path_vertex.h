#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/ray.h"
#include "geometry/spawn_ray.h"
#include "geometry/surface_point.h"
#include "integrators/integrator.h"
#include "integrators/medium_stack.h"
#include "materials/bsdf.h"
#include "materials/material.h"
#include "math/vec.h"
#include "scene/interior.h"

namespace candela {

struct IntegratorOptions;

// What paths from the camera and paths from lights have in common.

/// What a surface does with a path; each has a limit of its own.
enum BounceKind : uint8_t { kDiffuse, kMirror, kTransmission };

inline BounceKind KindOf(bool is_delta, bool is_transmission) {
  if (is_transmission) return kTransmission;
  return is_delta ? kMirror : kDiffuse;
}

/// How often surfaces have scattered a path; holes that it has gone through do not count.
struct BounceCounts {
  uint32_t all = 0;
  std::array<uint32_t, 3> of_kind{};

  void Add(BounceKind kind) {
    ++all;
    ++of_kind[kind];
  }
};

/// How often they may.
struct BounceLimits {
  explicit BounceLimits(const IntegratorOptions& options);

  bool Allow(const BounceCounts& counts) const { return counts.all < all; }
  bool Allow(const BounceCounts& counts, BounceKind kind) const {
    return counts.of_kind[kind] < of_kind[kind];
  }

  uint32_t all;
  std::array<uint32_t, 3> of_kind;
};

/// A surface that a path has met.
struct PathVertex {
  PathVertex(const Scene& scene, const Ray& ray, const HitRecord& hit)
      : point(scene.SurfaceAt(ray, hit)), wo(-Normalize(ray.direction)) {}
  PathVertex(const SurfacePoint& surface_point, Vec3 w) : point(surface_point), wo(w) {}

  SurfacePoint point;
  Vec3 wo;  ///< Unit vector to where the path comes from.
  Bsdf bsdf;
  const Material* material;
  bool is_lifted = false;    ///< See `Scene::LiftOf`.
  MediumStack media_beyond;  ///< What light is in that goes through into a body, or out of it.

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
  return SpawnRay(vertex.point, w, vertex.is_lifted ? vertex.wo : w);
}

/// The ray that goes on as if the surface were not there.
inline Ray PassOn(const PathVertex& vertex) {
  Ray ray = SpawnRay(vertex.point, -vertex.wo);
  ray.mask = kReflectionRay;
  return ray;
}

}  // namespace candela
