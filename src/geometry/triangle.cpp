#include "geometry/triangle.h"

#include <algorithm>

namespace candela {

bool ExactBarycentrics(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c, TriangleHit* hit) {
  const Vec2 pa = ray.Shear(a), pb = ray.Shear(b), pc = ray.Shear(c);
  const auto area = [](Vec2 p, Vec2 q) { return double{p.x} * q.y - double{p.y} * q.x; };
  const double area_a = area(pc, pb), area_b = area(pa, pc), area_c = area(pb, pa);
  const bool has_negative = area_a < 0 || area_b < 0 || area_c < 0;
  const bool has_positive = area_a > 0 || area_b > 0 || area_c > 0;
  if (has_negative == has_positive) return false;  // Outside; or all 0: seen edge-on.
  const double sum = area_a + area_b + area_c;
  if (!std::isfinite(sum)) return false;  // Differences of the largest floats are not finite.
  hit->u = static_cast<float>(area_b / sum);
  hit->v = static_cast<float>(area_c / sum);

  // A point of an edge lies between its ends, one at a corner is there. The distance to the plane
  // would be anywhere when that is seen nearly edge-on.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double nearest = kInfinity, farthest = -kInfinity;
  const auto extend = [&](double weight, Vec3 corner) {
    if (weight == 0) return;
    const double t = (double{corner[ray.kz]} - ray.origin[ray.kz]) / ray.direction[ray.kz];
    nearest = std::min(nearest, t);
    farthest = std::max(farthest, t);
  };
  extend(area_a, a);
  extend(area_b, b);
  extend(area_c, c);
  hit->t = std::clamp(hit->t, static_cast<float>(nearest), static_cast<float>(farthest));
  return true;
}

void KeepInBox(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c, TriangleHit* hit) {
  double entry = hit->t;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    if (direction == 0) continue;
    const float near = direction > 0 ? std::min({a[axis], b[axis], c[axis]})
                                     : std::max({a[axis], b[axis], c[axis]});
    const double t = (near - origin) / direction;
    // The rounding of a distance makes no difference to a search.
    const double rounding = (std::abs(origin) + std::abs(double{near})) * 1.2e-7;
    if (hit->t < t - rounding / std::abs(direction)) entry = std::max(entry, t);
  }
  hit->t = static_cast<float>(entry);
}

}  // namespace candela
