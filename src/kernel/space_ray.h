#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/ray.h"
#include "geometry/triangle.h"
#include "kernel/record.h"

namespace candela::kernel {

/// What the box test needs of a ray. The distance to a plane is `plane * scale - offset`, with
/// constants of its own for near and far planes, which move both ends outwards by more than all
/// roundings of the test and of the distance of a hit: after Ize, "Robust BVH Ray Traversal", 2013,
/// but at no cost in the loop.
struct Slabs {
  float near_scale[3], near_offset[3], far_scale[3], far_offset[3];
  uint32_t near_row[3];  ///< A `BoxRow`; the far one is `near_row ^ 1`.
  float t_min;
};

/// Whether a ray can hit anything; comparisons alone would not always see that it cannot.
template <class L>
[[gnu::always_inline]] inline bool IsTraceable(Vec3 origin, Vec3 direction) {
  const float length = LengthSquared(direction);
  const float far = std::abs(origin.x) + std::abs(origin.y) + std::abs(origin.z);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return length > 0 && length < kInfinity && far < kInfinity;
}

/// A ray in the space of a group, prepared for its tests. Filled in place, member by member: copies
/// of what has just been written in parts make the processor wait.
struct SpaceRay {
  Slabs slabs;
  ShearedRay sheared;
  float farthest;  ///< The largest coordinate of the origin and of the group, by magnitude.

  /// `t_min` is not -0. `largest` is the largest coordinate of the group's bounds, by magnitude.
  template <class L>
  [[gnu::always_inline]] void Set(Vec3 origin, Vec3 direction, float t_min, float largest) {
    sheared.Set(origin, direction);
    slabs.t_min = t_min;
    farthest = std::max(std::max(std::abs(origin.x), std::abs(origin.y)),
                        std::max(std::abs(origin.z), largest));
    const bool is_usual = farthest <= kUsualCoordinate;
    SetAxis<L>(0, origin.x, direction.x, is_usual);
    SetAxis<L>(1, origin.y, direction.y, is_usual);
    SetAxis<L>(2, origin.z, direction.z, is_usual);
  }

  /// Reciprocals of direction components beyond this are replaced, so that no product overflows.
  static constexpr float kUsualSlope = 1e15f;
  /// And for coordinates beyond this the bound on them is lower.
  static constexpr float kUsualCoordinate = 1e20f;
  // More than the errors of the reciprocal, of two products and of the sum, and of a hit's t: see
  // docs/kernel.md.
  static constexpr float kScaleSlack = 3e-7f, kOffsetSlack = 8e-7f;
  static constexpr float kLeastSlack = std::numeric_limits<float>::min();  ///< Of tiny numbers.

 private:
  template <class L>
  [[gnu::always_inline]] void SetAxis(int axis, float origin, float direction, bool is_usual) {
    float slope = 1 / direction;
    float least_slack = kLeastSlack;
    if (!(is_usual && std::abs(slope) <= kUsualSlope)) [[unlikely]] {
      // As steep as the coordinates allow. A ray along a slab would then leave it early, in the
      // plane of a face at once: let it stay as long as anything can be away. (Finite, since the
      // boxes of children that are not there are infinite. Coordinates beyond 1e37 are too far.)
      const float steepest = 1e37f / std::max(1.0f, farthest);
      slope = std::copysign(std::min(std::abs(slope), steepest), direction);
      least_slack = std::min(4 * (farthest / std::abs(sheared.direction[sheared.kz])), 8e37f);
    }
    const float offset = origin * slope;
    const float slack = std::abs(offset) * kOffsetSlack + least_slack;
    slabs.near_scale[axis] = slope * (1 - kScaleSlack);
    slabs.far_scale[axis] = slope * (1 + kScaleSlack);
    slabs.near_offset[axis] = offset + slack;
    slabs.far_offset[axis] = offset - slack;
    slabs.near_row[axis] = static_cast<uint32_t>(2 * axis) + (slope < 0 ? 1u : 0u);
  }
};

}  // namespace candela::kernel
