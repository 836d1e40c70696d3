#pragma once

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
    moved.offset_ = offset;
    return moved;
  }

  Vec3 Point(Vec3 p) const { return Vector(p) + offset_; }
  Vec3 Vector(Vec3 v) const { return is_translation_ ? v : x_ * v.x + y_ * v.y + z_ * v.z; }

  /// Bound on the error of `Point(p)` in each coordinate, when `p` itself is known to `p_error`.
  Vec3 PointError(Vec3 p, Vec3 p_error) const {
    constexpr float kRounding = 3e-7f;  // Three products and three sums: under 5 half-ulps.
    const Vec3 carried = Abs(x_) * p_error.x + Abs(y_) * p_error.y + Abs(z_) * p_error.z;
    const Vec3 rounded = Abs(x_ * p.x) + Abs(y_ * p.y) + Abs(z_ * p.z) + Abs(offset_);
    return carried * (1 + kRounding) + rounded * kRounding;
  }

  /// Multiplies by the transpose of the linear part. A normal goes from object to world by the
  /// inverse transpose, so: `n_world = object_from_world.TransposedVector(n_object)`, to normalise.
  Vec3 TransposedVector(Vec3 v) const { return {Dot(x_, v), Dot(y_, v), Dot(z_, v)}; }

  /// Where a normal goes to, as a vector of any length: multiplies by the inverse transpose, but
  /// for a positive factor.
  Vec3 Normal(Vec3 n) const {
    if (is_translation_) return n;
    const Vec3 image = Cross(y_, z_) * n.x + Cross(z_, x_) * n.y + Cross(x_, y_) * n.z;
    return Dot(Cross(x_, y_), z_) < 0 ? -image : image;
  }

 private:
  Vec3 x_{1, 0, 0}, y_{0, 1, 0}, z_{0, 0, 1};  // columns: images of the axes
  Vec3 offset_;
  bool is_translation_ = true;  ///< Most nodes only move things: then the linear part is left out.
};

}  // namespace candela
