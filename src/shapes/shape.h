#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "geometry/bounds3.h"
#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "geometry/surface_point.h"
#include "kernel/group_input.h"
#include "math/mat4.h"
#include "math/transform.h"
#include "shapes/surface_sampler.h"

namespace candela {

/// A surface in its own object space. Rays arrive already transformed, with a direction that is not
/// normalised, so `t` means the same in object and world space. Immutable; called concurrently.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Whether it changes over time. Then hits are those at the times of their rays.
  virtual bool IsMoving() const { return false; }

  /// A box around the surface, at all times; unbounded shapes return `Bounds3::Infinite()`.
  virtual Bounds3 ObjectBounds() const = 0;

  /// Looks for the nearest hit with `ray.t_min <= t < hit->t`. On success stores t, u, v and the
  /// primitive (0 for a shape that does not consist of triangles) and returns true; on a miss
  /// leaves
  /// `*hit` as it was. Of equal t within the shape the primitive with the smallest index wins.
  virtual bool Intersect(const Ray& ray, HitRecord* hit) const = 0;

  /// Whether anything of it lies in `ray.t_min <= t < ray.t_max`.
  virtual bool Occludes(const Ray& ray) const;

  /// Position and normals of a hit found by `Intersect`, in object space; normals have any length
  /// but 0, the geometric one of a shape of triangles has length 1. Kept apart because most hits
  /// found during traversal are replaced by nearer ones.
  virtual SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const = 0;

  /// The normal that `SurfaceAt` gives for all hits of a flat shape, as both, in object space and
  /// of any length; 0 for others, and for shapes of triangles.
  virtual Vec3 FlatNormal() const { return {}; }

  /// Adds texture coordinates, and how the point moves with them, to what `SurfaceAt` gave. Kept
  /// apart because few materials ask for them. Unless the shape knows better, they are where on the
  /// primitive the hit lies, and say nothing about directions. A shape that is moving looks at
  /// `point->time`.
  virtual void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
    point->uv = {hit.u, hit.v};
  }

  /// How far outside of a point, the one of a hit, the round surface lies that the shading normals
  /// pretend; 0 where there is none, where it does not bulge, and where an edge is smoothed over.
  /// With `is_inside` the same towards the inside. `time` is that of the ray.
  virtual Vec3 LiftOf(const HitRecord& /*hit*/, Vec3 /*p*/, float /*time*/,
                      bool /*is_inside*/) const {
    return {};
  }

  /// The triangles, when that is all it consists of; then the scene's own search finds their hits,
  /// and does not ask `Intersect`, which says the same about a single shape at leisure. What the
  /// spans refer to lives as long as the shape.
  virtual std::optional<TriangleInput> Triangles() const { return std::nullopt; }

  /// For a shape of triangles: the same surface in the space that the matrix leads to, with normals
  /// on the same side. Null when it does not fit into single precision.
  virtual std::shared_ptr<const Shape> Baked(const Mat4& /*world_from_object*/) const {
    return nullptr;
  }

  /// What draws points of the surface where it stands in the world, for a light. It may refer to
  /// the shape. Null for a shape without one, or without end: as a light it is found by rays alone.
  virtual std::unique_ptr<const SurfaceSampler> MakeSampler(
      const Transform& world_from_object, const Transform& object_from_world) const;

  /// How many primitives it consists of, for statistics.
  virtual uint64_t PrimitiveCount() const { return 1; }
  virtual uint64_t MemoryBytes() const = 0;
};

}  // namespace candela
