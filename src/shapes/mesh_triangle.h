#pragma once

#include <array>
#include <cstddef>

#include "geometry/hit_record.h"
#include "geometry/surface_point.h"
#include "geometry/triangle.h"
#include "math/vec.h"

namespace candela {

/// A triangle of a mesh with all that is known of its corners.
struct MeshTriangle {
  std::array<Vec3, 3> p;
  std::array<Vec3, 3> n;     ///< Of any length; 0 where a corner has none, and the face's counts.
  bool is_mirrored = false;  ///< The face's normal points to where the corners are clockwise.

  Vec3 FaceNormal() const {
    const Vec3 normal = TriangleNormal(p[0], p[1], p[2]);
    return is_mirrored ? -normal : normal;
  }

  /// No corner has a normal.
  bool IsFlat() const { return n[0] == Vec3() && n[1] == Vec3() && n[2] == Vec3(); }

  SurfacePoint SurfaceAt(const HitRecord& hit) const {
    const Vec3 face_normal = FaceNormal();
    return {TrianglePoint(p[0], p[1], p[2], hit.u, hit.v),
            TrianglePointError(p[0], p[1], p[2], hit.u, hit.v), face_normal,
            ShadingNormal(hit, face_normal)};
  }

  /// See `Shape::LiftOf`.
  Vec3 LiftOf(const HitRecord& hit, Vec3 point, bool is_inside) const;

  /// Adds texture coordinates, of which those of the corners are given.
  void AddTextureCoordinates(const std::array<Vec2, 3>& uvs, const HitRecord& hit,
                             SurfacePoint* point) const;

 private:
  Vec3 ShadingNormal(const HitRecord& hit, Vec3 face_normal) const {
    if (IsFlat()) return face_normal;  // Blending three of them would round.
    const auto normal = [&](size_t k) { return n[k] == Vec3() ? face_normal : n[k]; };
    const Vec3 blended = normal(0) * (1 - hit.u - hit.v) + normal(1) * hit.u + normal(2) * hit.v;
    return blended == Vec3() ? face_normal : blended;
  }
};

}  // namespace candela
