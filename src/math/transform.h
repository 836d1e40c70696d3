#pragma once

#include <cmath>

#include "math/float4.h"
#include "math/mat4.h"
#include "math/vec.h"

namespace candela {

/// An affine map in single precision for the hot paths. Named after what it does, read right to
/// left: `p_world = world_from_object.Point(p_object)`.
class Transform {
 public:
  /// The identity.
  Transform() = default;
  explicit Transform(const Mat4& matrix);

  /// The map with the same linear part that takes the origin to `offset`.
  Transform WithOffset(Vec3 offset) const {
    Transform moved = *this;
    moved.offset_ = ToFloat4(offset);
    return moved;
  }

  Vec3 Point(Vec3 p) const {
    return is_translation_ ? p + ToVec3(offset_) : ToVec3(Linear(p) + offset_);
  }
  Vec3 Vector(Vec3 v) const { return is_translation_ ? v : ToVec3(Linear(v)); }

  /// Bound on the error of `Point(p)` in each coordinate, when `p` itself is known to `p_error`.
  Vec3 PointError(Vec3 p, Vec3 p_error) const {
    constexpr float kRounding = 3e-7f;  // Three products and three sums: under 5 half-ulps.
    const Float4 x = Abs(x_), y = Abs(y_), z = Abs(z_);
    const Float4 carried =
        x * Broadcast(p_error.x) + y * Broadcast(p_error.y) + z * Broadcast(p_error.z);
    const Float4 rounded = x * Broadcast(std::abs(p.x)) + y * Broadcast(std::abs(p.y)) +
                           z * Broadcast(std::abs(p.z)) + Abs(offset_);
    return ToVec3(carried * Broadcast(1 + kRounding) + rounded * Broadcast(kRounding));
  }

  /// Multiplies by the transpose of the linear part. A normal goes from object to world by the
  /// inverse transpose, so: `n_world = object_from_world.TransposedVector(n_object)`, to normalise.
  Vec3 TransposedVector(Vec3 v) const {
    return {Dot(ToVec3(x_), v), Dot(ToVec3(y_), v), Dot(ToVec3(z_), v)};
  }

  /// Where a normal goes to, as a vector of any length: multiplies by the inverse transpose, but
  /// for a positive factor.
  Vec3 Normal(Vec3 n) const {
    if (is_translation_) return n;
    const Vec3 x = ToVec3(x_), y = ToVec3(y_), z = ToVec3(z_);
    const Vec3 image = Cross(y, z) * n.x + Cross(z, x) * n.y + Cross(x, y) * n.z;
    return Dot(Cross(x, y), z) < 0 ? -image : image;
  }

 private:
  Float4 Linear(Vec3 v) const {
    return x_ * Broadcast(v.x) + y_ * Broadcast(v.y) + z_ * Broadcast(v.z);
  }

  // Columns: images of the axes, and of the origin.
  Float4 x_{1, 0, 0, 0}, y_{0, 1, 0, 0}, z_{0, 0, 1, 0}, offset_{};
  bool is_translation_ = true;  ///< Most nodes only move things: then the linear part is left out.
};

}  // namespace candela
