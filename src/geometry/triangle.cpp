#include "geometry/triangle.h"

namespace candela {

bool ExactBarycentrics(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c, TriangleHit* hit) {
  const Vec2 pa = ray.Shear(a), pb = ray.Shear(b), pc = ray.Shear(c);
  const auto area = [](Vec2 p, Vec2 q) { return double{p.x} * q.y - double{p.y} * q.x; };
  const double area_a = area(pc, pb), area_b = area(pa, pc), area_c = area(pb, pa);
  const bool has_negative = area_a < 0 || area_b < 0 || area_c < 0;
  const bool has_positive = area_a > 0 || area_b > 0 || area_c > 0;
  if (has_negative == has_positive) return false;  // Outside; or all 0: seen edge-on.
  const double sum = area_a + area_b + area_c;
  hit->u = static_cast<float>(area_b / sum);
  hit->v = static_cast<float>(area_c / sum);
  return true;
}

}  // namespace candela
