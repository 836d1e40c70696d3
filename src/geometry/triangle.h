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
  Vec3 origin, direction;
  /// The first two coordinates of the sheared space as functions of the difference to the origin.
  /// Two components are 1 and 0 in some order, so a product with one of them rounds once.
  Vec3 row_x, row_y;

  explicit ShearedRay(const Ray& ray) : origin(ray.origin), direction(ray.direction) {
    const int kz = LargestAxis(ray.direction);
    int kx = (kz + 1) % 3;
    int ky = (kx + 1) % 3;
    if (ray.direction[kz] < 0) std::swap(kx, ky);  // Keeps the winding.
    row_x[kx] = 1;
    row_x[kz] = -(ray.direction[kx] / ray.direction[kz]);
    row_y[ky] = 1;
    row_y[kz] = -(ray.direction[ky] / ray.direction[kz]);
  }
};

/// The normal on the side where the corners are seen counter-clockwise, as long as twice the area.
/// In double, where it is right for triangles of any size and shape.
inline Vec3d TriangleCross(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3d corner = ToDouble(a);
  return Cross(ToDouble(b) - corner, ToDouble(c) - corner);
}

/// The unit normal on the same side; 0 for a triangle without area.
inline Vec3 TriangleNormal(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3d n = TriangleCross(a, b, c);
  const double length = Length(n);
  return length > 0 ? ToFloat(n / length) : Vec3();
}

/// Looks for a hit of the closed triangle, from either side, with `t_min <= t < hit->t`. On success
/// stores t and the barycentric weights u of `b` and v of `c`; on a miss leaves `*hit` as it was.
inline bool IntersectTriangle(const ShearedRay& ray, float t_min, Vec3 a, Vec3 b, Vec3 c,
                              HitRecord* hit) {
  const Vec3 to_a = a - ray.origin, to_b = b - ray.origin, to_c = c - ray.origin;
  const float ax = Dot(ray.row_x, to_a), ay = Dot(ray.row_y, to_a);
  const float bx = Dot(ray.row_x, to_b), by = Dot(ray.row_y, to_b);
  const float cx = Dot(ray.row_x, to_c), cy = Dot(ray.row_y, to_c);

  // Twice the signed areas that the ray's point spans with each edge. Rounding keeps the order of
  // two products, so a sign is right unless they round to the same: then the area is 0, or not a
  // number when they overflow.
  float area_a = cx * by - cy * bx;
  float area_b = ax * cy - ay * cx;
  float area_c = bx * ay - by * ax;
  const auto are_on_both_sides = [](auto p, auto q, auto r) {
    return (p < 0 || q < 0 || r < 0) && (p > 0 || q > 0 || r > 0);
  };
  if (are_on_both_sides(area_a, area_b, area_c)) return false;

  const float sum = area_a + area_b + area_c;
  const bool is_on_edge = area_a == 0 || area_b == 0 || area_c == 0;
  float u, v;
  if (!is_on_edge && std::abs(sum) > 1e-37f && std::abs(sum) < 1e37f) {
    u = area_b / sum;
    v = area_c / sum;
  } else {
    // In double the products are exact, and their range is wide enough for all floats.
    const auto area = [](double px, double py, double qx, double qy) { return px * qy - py * qx; };
    const double exact_a = area(cx, cy, bx, by);
    const double exact_b = area(ax, ay, cx, cy);
    const double exact_c = area(bx, by, ax, ay);
    if (are_on_both_sides(exact_a, exact_b, exact_c)) return false;
    const double exact_sum = exact_a + exact_b + exact_c;
    if (exact_sum == 0) return false;  // Seen edge-on.
    u = static_cast<float>(exact_b / exact_sum);
    v = static_cast<float>(exact_c / exact_sum);
  }

  // The distance to the plane, in double: blending the corners' depths is wrong by the rounding of
  // the triangle's size, so that rays which leave a large triangle would hit it again.
  const Vec3d n = TriangleCross(a, b, c);
  const auto t = static_cast<float>(Dot(n, ToDouble(a) - ToDouble(ray.origin)) /
                                    Dot(n, ToDouble(ray.direction)));
  if (!(t >= t_min && t < hit->t)) return false;  // Written so that NaN is a miss.
  hit->t = t;
  hit->u = u;
  hit->v = v;
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
