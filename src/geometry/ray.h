#pragma once

#include <cstdint>
#include <limits>

#include "math/vec.h"

namespace candela {

/// What a ray is sent for, as bits of a mask: surfaces may be visible to some kinds only.
enum RayKind : uint32_t {
  kCameraRay = 1,
  kReflectionRay = 2,  ///< Mirror reflections and bounces of paths.
  kShadowRay = 4,      ///< Asks whether light is stopped: passes surfaces with holes,
  kHoleRay = 8,        ///< which are there for this one.
  kAnyRay = 0xFFFFFFFF,
};

/// The part t_min <= t < t_max of the half-line o + t d. The direction is not normalised when a ray
/// is taken to object space, so t means the same everywhere.
struct Ray {
  Vec3 origin;
  float t_min = 0;  ///< Not negative.
  Vec3 direction;
  float t_max = std::numeric_limits<float>::max();  ///< Hits have t < t_max.
  float time = 0;                                   ///< In [0, 1], over the shutter interval.
  uint32_t mask = kAnyRay;  ///< Kinds it belongs to; a surface with none of them is passed.

  Ray() = default;
  Ray(Vec3 ray_origin, Vec3 ray_direction) : origin(ray_origin), direction(ray_direction) {}

  Vec3 At(float t) const { return origin + direction * t; }
};

}  // namespace candela
