#pragma once

#include <algorithm>
#include <cmath>

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

/// A ray in the space of a group, prepared for its tests.
struct SpaceRay {
  Slabs slabs;
  ShearedRay sheared;
  Ray ray;
};

/// Whether a ray can hit anything; comparisons alone would not always see that it cannot.
template <class L>
bool IsTraceable(const Ray& ray) {
  const float length = LengthSquared(ray.direction);
  return length > 0 && length <= std::numeric_limits<float>::max() && IsFinite(ray.origin) &&
         ray.t_min >= 0;
}

/// Reciprocals of direction components beyond this are replaced, so that no product overflows.
constexpr float kUsualSlope = 1e15f;
/// And for coordinates beyond this the bound on them is lower.
constexpr float kUsualCoordinate = 1e20f;

/// `largest` is the largest coordinate of the group's bounds, by magnitude.
template <class L>
Slabs MakeSlabs(const Ray& ray, float largest) {
  // Errors of the reciprocal, of two products and of the sum, for hits as well: see docs/kernel.md.
  constexpr float kScaleSlack = 3e-7f, kOffsetSlack = 8e-7f;
  Slabs slabs;
  slabs.t_min = ray.t_min + 0.0f;  // Turns -0 into 0, whose bits are ordered like the others.
  const float farthest = std::max(std::max(std::abs(ray.origin.x), std::abs(ray.origin.y)),
                                  std::max(std::abs(ray.origin.z), largest));
  for (int axis = 0; axis < 3; ++axis) {
    float slope = 1 / ray.direction[axis];
    if (!(std::abs(slope) <= kUsualSlope && farthest <= kUsualCoordinate)) {
      // As steep as the coordinates allow: a ray along a slab then leaves it practically never.
      const float steepest = 1e37f / std::max(1.0f, farthest);
      slope = std::copysign(std::min(std::abs(slope), steepest), ray.direction[axis]);
    }
    const float offset = ray.origin[axis] * slope;
    const float slack = std::abs(offset) * kOffsetSlack;
    slabs.near_scale[axis] = slope * (1 - kScaleSlack);
    slabs.far_scale[axis] = slope * (1 + kScaleSlack);
    slabs.near_offset[axis] = offset + slack;
    slabs.far_offset[axis] = offset - slack;
    slabs.near_row[axis] = static_cast<uint32_t>(2 * axis) + (slope < 0 ? 1u : 0u);
  }
  return slabs;
}

template <class L>
SpaceRay MakeSpaceRay(const Ray& ray, float largest) {
  return {MakeSlabs<L>(ray, largest), ShearedRay(ray), ray};
}

}  // namespace candela::kernel
