#pragma once

#include <cmath>
#include <utility>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "math/vec.h"

namespace candela {

/// A ray prepared for triangles after Woop, Benthin and Wald, "Watertight Ray/Triangle
/// Intersection", 2013: shearing takes the ray to the z axis, so that an edge shared by two
/// triangles is judged by the very same numbers for both.
struct ShearedRay {
  Vec3 origin;
  int kx, ky, kz;  ///< Axes of the sheared space; kz is where the direction is largest.
  float shear_x, shear_y, shear_z;

  explicit ShearedRay(const Ray& ray) : origin(ray.origin) {
    kz = LargestAxis(ray.direction);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (ray.direction[kz] < 0) std::swap(kx, ky);  // Keeps the winding.
    shear_x = ray.direction[kx] / ray.direction[kz];
    shear_y = ray.direction[ky] / ray.direction[kz];
    shear_z = 1.0f / ray.direction[kz];
  }
};

/// Looks for a hit of the closed triangle, from either side, with `t_min <= t < hit->t`. On success
/// stores t and the barycentric weights u of `b` and v of `c`; on a miss leaves `*hit` as it was.
inline bool IntersectTriangle(const ShearedRay& ray, float t_min, Vec3 a, Vec3 b, Vec3 c,
                              HitRecord* hit) {
  const Vec3 to_a = a - ray.origin, to_b = b - ray.origin, to_c = c - ray.origin;
  const float ax = to_a[ray.kx] - ray.shear_x * to_a[ray.kz];
  const float ay = to_a[ray.ky] - ray.shear_y * to_a[ray.kz];
  const float bx = to_b[ray.kx] - ray.shear_x * to_b[ray.kz];
  const float by = to_b[ray.ky] - ray.shear_y * to_b[ray.kz];
  const float cx = to_c[ray.kx] - ray.shear_x * to_c[ray.kz];
  const float cy = to_c[ray.ky] - ray.shear_y * to_c[ray.kz];

  // Twice the signed areas that the ray's point spans with each edge.
  float area_a = cx * by - cy * bx;
  float area_b = ax * cy - ay * cx;
  float area_c = bx * ay - by * ax;
  if (area_a == 0 || area_b == 0 || area_c == 0) {
    // On an edge in single precision: double, in which the products are exact, tells the side.
    const auto area = [](float px, float py, float qx, float qy) {
      return static_cast<float>(static_cast<double>(px) * qy - static_cast<double>(py) * qx);
    };
    area_a = area(cx, cy, bx, by);
    area_b = area(ax, ay, cx, cy);
    area_c = area(bx, by, ax, ay);
  }
  const bool any_negative = area_a < 0 || area_b < 0 || area_c < 0;
  const bool any_positive = area_a > 0 || area_b > 0 || area_c > 0;
  if (any_negative && any_positive) return false;
  const float sum = area_a + area_b + area_c;
  if (!(sum != 0)) return false;  // Seen edge-on, or not a number.

  const float inverse = 1.0f / sum;
  const float depth = area_a * to_a[ray.kz] + area_b * to_b[ray.kz] + area_c * to_c[ray.kz];
  const float t = depth * ray.shear_z * inverse;
  if (!(t >= t_min && t < hit->t)) return false;
  hit->t = t;
  hit->u = area_b * inverse;
  hit->v = area_c * inverse;
  return true;
}

/// The point with barycentric weights u of `b` and v of `c`.
inline Vec3 TrianglePoint(Vec3 a, Vec3 b, Vec3 c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

/// Bound on the rounding error of `TrianglePoint` in each coordinate.
inline Vec3 TrianglePointError(Vec3 a, Vec3 b, Vec3 c, float u, float v) {
  return (Abs(a * (1 - u - v)) + Abs(b * u) + Abs(c * v)) * 6e-7f;
}

}  // namespace candela
