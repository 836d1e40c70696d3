#include "shapes/sphere.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/elementary.h"

namespace candela {

std::shared_ptr<const Shape> Sphere::Create(ParamReader* params, ShapeContext*) {
  return std::make_unique<Sphere>(params->RequiredPositive("radius"));
}

Bounds3 Sphere::ObjectBounds() const {
  return {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}};
}

// Inserting p = o + t d into |p|^2 = r^2 gives a t^2 - 2 b t + c = 0. The discriminant is computed
// from the distance of the centre to the ray, and the root that would cancel from the product of
// both: Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection",
// 2019. In double, so that the squares of very small and very large spheres keep their value.
bool Sphere::Intersect(const Ray& ray, HitRecord* hit) const {
  const Vec3d origin = ToDouble(ray.origin), direction = ToDouble(ray.direction);
  const double r2 = double{radius_} * radius_;
  const double a = Dot(direction, direction);
  const double b = -Dot(origin, direction);
  const Vec3d nearest = origin + direction * (b / a);  // Foot of the perpendicular.
  const double within = r2 - Dot(nearest, nearest);
  if (!(within >= 0)) return false;  // Written so that NaN is a miss.

  const double c = Dot(origin, origin) - r2;
  const double q = b + std::copysign(std::sqrt(a * within), b);
  // q is 0 for a ray that touches the sphere where it starts.
  double t0 = q != 0 ? c / q : 0, t1 = q / a;
  if (t0 > t1) std::swap(t0, t1);
  const auto near = static_cast<float>(t0), far = static_cast<float>(t1);
  const float t = near >= ray.t_min ? near : far;
  if (!(t >= ray.t_min && t < hit->t)) return false;
  hit->t = t;
  hit->u = hit->v = 0;
  hit->primitive = 0;
  return true;
}

SurfacePoint Sphere::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  // Pushed onto the sphere, the point is as exact as its coordinates can say.
  const Vec3 normal = NormalizeAnyLength(ray.At(hit.t));
  const Vec3 p = normal * radius_;
  return {p, Abs(p) * 6e-7f, normal, normal};
}

// Like a globe whose axis is y: u goes around to the right, as seen from outside, with its middle
// at +z; v goes from the lowest point up.
void Sphere::AddTextureCoordinates(const HitRecord&, SurfacePoint* point) const {
  constexpr auto kPiF = static_cast<float>(kPi);
  const Vec3 p = point->p, n = point->n_geometric;
  point->uv = {0.5f + Atan2(n.x, n.z) / (2 * kPiF),
               0.5f + Asin(std::clamp(n.y, -1.0f, 1.0f)) / kPiF};
  point->dpdu = Vec3{p.z, 0, -p.x} * (2 * kPiF);
  const float from_axis = std::sqrt(n.x * n.x + n.z * n.z);
  // At the poles u says nothing, and v goes down on all sides.
  if (from_axis == 0) return;
  point->dpdv = Vec3{-n.y * n.x / from_axis, from_axis, -n.y * n.z / from_axis} * (radius_ * kPiF);
}

}  // namespace candela
