#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/ray.h"
#include "math/elementary.h"
#include "math/vec.h"

namespace candela {

// How the course follows light from surface to surface. Its pictures depend on all of it.

/// The course moves new rays by this much along themselves, whatever the size of the scene.
inline constexpr float kCourseOffset = 0.01f;

/// A surface whose specular colour is shorter than this does not mirror.
inline constexpr float kLeastMirror = 0.01f;

/// The course knows no holes: what has some throws the shadow of the whole.
inline constexpr uint32_t kWholeShadowRay = kShadowRay | kHoleRay;

inline Vec3 Mirrored(Vec3 d, Vec3 n) {
  return d - n * (2 * Dot(n, d));
}

/// max(0, cosine) to the power of the shininess, where 0 to the power of 0 is 1.
inline float Highlight(float cosine, float shininess) {
  if (shininess == 0) return 1;
  return cosine > 0 ? Pow(cosine, shininess) : (shininess > 0 ? 0.0f : Pow(0.0f, shininess));
}

/// A ray that leaves a point. Written in place, member by member: a ray that is made elsewhere and
/// copied would wait for its own members to be stored.
inline void StartRay(Vec3 p, Vec3 direction, uint32_t mask, float t_max, float time, Ray* ray) {
  ray->origin = p + direction * kCourseOffset;
  ray->t_min = 0;
  ray->direction = direction;
  ray->t_max = t_max;
  ray->time = time;
  ray->mask = mask;
}

/// Where shadow rays to a light end. A hit exactly as far as the light counts. The distance is that
/// of the unmoved point.
inline float ShadowLimit(float distance) {
  constexpr float kFarthest = std::numeric_limits<float>::max();
  return distance < kFarthest ? std::nextafter(distance, kFarthest) : kFarthest;
}

}  // namespace candela
