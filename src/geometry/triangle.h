#pragma once

#include <cmath>
#include <limits>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "math/vec.h"

namespace candela {

/// A ray prepared for triangles after Woop, Benthin and Wald, "Watertight Ray/Triangle
/// Intersection", 2013: shearing takes the ray to the z axis, so that an edge shared by two
/// triangles is judged by the very same numbers for both.
struct ShearedRay {
  Vec3 origin, direction;
  int kx = 0, ky = 1, kz = 2;  ///< The axes in a new order; z is the one that the ray follows most.
  float origin_x = 0, origin_y = 0, origin_z = 0;  ///< The origin in that order.
  float shear_x = 0, shear_y = 0;

  ShearedRay() = default;
  explicit ShearedRay(const Ray& ray) { Set(ray.origin, ray.direction); }

  /// Without branches, which would follow no pattern for rays of all directions.
  [[gnu::always_inline]] void Set(Vec3 new_origin, Vec3 new_direction) {
    origin = new_origin;
    direction = new_direction;
    const float o[3] = {origin.x, origin.y, origin.z};
    const float d[3] = {direction.x, direction.y, direction.z};
    const float x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
    const int y_is_larger = !(x >= y);
    const int z_is_largest = !((x >= y ? x : y) >= z);
    kz = y_is_larger + z_is_largest * (2 - y_is_larger);
    // The axes that follow it; against the axis in the other order, which keeps the winding.
    static constexpr int kFollowing[2][3][2] = {{{1, 2}, {2, 0}, {0, 1}}, {{2, 1}, {0, 2}, {1, 0}}};
    const auto& following = kFollowing[d[kz] < 0][kz];
    kx = following[0];
    ky = following[1];
    origin_x = o[kx];
    origin_y = o[ky];
    origin_z = o[kz];
    shear_x = -(d[kx] / d[kz]);
    shear_y = -(d[ky] / d[kz]);
  }

  /// Where the ray's line meets the plane through `p` is the origin of these coordinates.
  Vec2 Shear(Vec3 p) const {
    const float to_z = p[kz] - origin_z;
    return {(p[kx] - origin_x) + to_z * shear_x, (p[ky] - origin_y) + to_z * shear_y};
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

/// Twice the signed areas that the ray's point spans with each edge, `a` opposite to corner a.
/// Rounding keeps the order of two products, so a sign is right unless they round to the same: then
/// the area is 0, or not a number when they overflow.
struct EdgeAreas {
  float a, b, c;

  /// Whether the point certainly lies outside of one edge and inside of another.
  bool AreMixed() const { return (a < 0 || b < 0 || c < 0) && (a > 0 || b > 0 || c > 0); }
};

/// Where a ray meets a triangle.
struct TriangleHit {
  float t;
  float u, v;  ///< Barycentric weights of the second and third corner.
};

/// The weights from products in double, which are exact, and whose range is wide enough for all
/// floats. Keeps t between those of the corners that have a weight. False when the point lies
/// outside after all, or the triangle is seen edge-on.
bool ExactBarycentrics(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c, TriangleHit* hit);

/// Moves a hit that lies before the box around its triangle to where the ray enters that.
void KeepInBox(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c, TriangleHit* hit);

/// Weights and distance for a triangle whose areas are not mixed; false when it is a miss after
/// all. No coordinate of the origin and of the corners is larger than `farthest`, which changes the
/// time, not the result. Always inlined, since it is compiled for several instruction sets.
[[gnu::always_inline]] inline bool FinishTriangle(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c,
                                                  const EdgeAreas& areas, float farthest,
                                                  TriangleHit* hit) {
  // The distance to the plane, in double: blending the corners' depths is wrong by the rounding of
  // the triangle's size, so that rays which leave a large triangle would hit it again.
  const double ax = a.x, ay = a.y, az = a.z;
  const double e1x = b.x - ax, e1y = b.y - ay, e1z = b.z - az;
  const double e2x = c.x - ax, e2y = c.y - ay, e2z = c.z - az;
  const double nx = e1y * e2z - e1z * e2y;
  const double ny = e1z * e2x - e1x * e2z;
  const double nz = e1x * e2y - e1y * e2x;
  const double height =
      nx * (ax - ray.origin.x) + ny * (ay - ray.origin.y) + nz * (az - ray.origin.z);
  const double approach = nx * ray.direction.x + ny * ray.direction.y + nz * ray.direction.z;
  hit->t = static_cast<float>(height / approach);

  const float sum = areas.a + areas.b + areas.c;
  const bool is_on_edge = areas.a == 0 || areas.b == 0 || areas.c == 0;
  if (is_on_edge || !(std::abs(sum) > 1e-37f && std::abs(sum) < 1e37f)) {
    if (!ExactBarycentrics(ray, a, b, c, hit)) return false;
  } else {
    hit->u = areas.b / sum;
    hit->v = areas.c / sum;
  }

  // Where rounding may have counted a ray that just misses as a hit, the plane may be met beside
  // the triangle, far when it is seen nearly edge-on. A hit before its box would be lost or not, by
  // the order of a search. Sheared coordinates are wrong by 5e-7 of the farthest one at most, and
  // an area by that times the coordinates of two corners, each less than twice the sum of the
  // edges.
  constexpr double kRounding = 4e-6;
  const double edges =
      std::abs(e1x) + std::abs(e1y) + std::abs(e1z) + std::abs(e2x) + std::abs(e2y) + std::abs(e2z);
  const float one = std::abs(areas.a), two = std::abs(areas.b), three = std::abs(areas.c);
  const float smaller = one < two ? one : two, smallest = smaller < three ? smaller : three;
  if (!(smallest > kRounding * farthest * edges)) [[unlikely]]
    KeepInBox(ray, a, b, c, hit);
  return true;
}

/// Looks for a hit of the closed triangle, from either side, with `t_min <= t < hit->t`. On success
/// stores t and the barycentric weights u of `b` and v of `c`; on a miss leaves `*hit` as it was.
inline bool IntersectTriangle(const ShearedRay& ray, float t_min, Vec3 a, Vec3 b, Vec3 c,
                              HitRecord* hit) {
  const Vec2 pa = ray.Shear(a), pb = ray.Shear(b), pc = ray.Shear(c);
  const EdgeAreas areas = {pc.x * pb.y - pc.y * pb.x, pa.x * pc.y - pa.y * pc.x,
                           pb.x * pa.y - pb.y * pa.x};
  TriangleHit found;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (areas.AreMixed() || !FinishTriangle(ray, a, b, c, areas, kInfinity, &found)) return false;
  if (!(found.t >= t_min && found.t < hit->t)) return false;  // Written so that NaN is a miss.
  hit->t = found.t;
  hit->u = found.u;
  hit->v = found.v;
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
