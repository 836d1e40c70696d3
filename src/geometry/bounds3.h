#pragma once

#include <limits>

#include "math/transform.h"
#include "math/vec.h"

namespace candela {

/// An axis-aligned box, closed. The default is empty: it contains nothing and extends to any point.
struct Bounds3 {
  Vec3 min{kInfinity, kInfinity, kInfinity};
  Vec3 max{-kInfinity, -kInfinity, -kInfinity};

  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  /// The box of unbounded shapes.
  static constexpr Bounds3 Infinite() {
    return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
  }

  bool IsEmpty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  bool IsFinite() const { return candela::IsFinite(min) && candela::IsFinite(max); }
  Vec3 Extent() const { return max - min; }
  Vec3 Center() const { return min * 0.5f + max * 0.5f; }
  bool Contains(Vec3 p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z &&
           p.z <= max.z;
  }

  void Extend(Vec3 p) {
    min = Min(min, p);
    max = Max(max, p);
  }
  void Extend(const Bounds3& other) {
    min = Min(min, other.min);
    max = Max(max, other.max);
  }

  /// Half of the surface area, the measure of the surface area heuristic; 0 when empty. In double,
  /// where neither the smallest nor the largest boxes lose it.
  double HalfArea() const {
    if (IsEmpty()) return 0;
    const Vec3d e = ToDouble(max) - ToDouble(min);
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }

  friend bool operator==(const Bounds3&, const Bounds3&) = default;
};

/// A box around the image of a box, widened by its rounding error. Unbounded boxes stay unbounded;
/// so does the image when it does not fit into single precision.
Bounds3 TransformBounds(const Transform& transform, const Bounds3& bounds);

}  // namespace candela
