#include "shapes/sphere.h"

#include <cmath>
#include <utility>

namespace candela {

std::unique_ptr<Shape> Sphere::Create(ParamReader* params, ShapeContext*) {
  return std::make_unique<Sphere>(params->RequiredPositive("radius"));
}

Bounds3 Sphere::ObjectBounds() const {
  return {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}};
}

// Inserting p = o + t d into |p|^2 = r^2 gives a t^2 - 2 b t + c = 0. The discriminant is computed
// from the distance of the centre to the ray, and the root that would cancel from the product of
// both: Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection",
// 2019.
bool Sphere::Intersect(const Ray& ray, HitRecord* hit) const {
  const float a = Dot(ray.direction, ray.direction);
  const float b = -Dot(ray.origin, ray.direction);
  const Vec3 nearest = ray.origin + ray.direction * (b / a);  // Foot of the perpendicular.
  const float within = radius_ * radius_ - Dot(nearest, nearest);
  if (!(within >= 0)) return false;  // Written so that NaN is a miss.

  const float c = Dot(ray.origin, ray.origin) - radius_ * radius_;
  const float q = b + std::copysign(std::sqrt(a * within), b);
  float t0 = c / q, t1 = q / a;
  if (t0 > t1) std::swap(t0, t1);
  const float t = t0 >= ray.t_min ? t0 : t1;
  if (!(t >= ray.t_min && t < hit->t)) return false;
  hit->t = t;
  hit->primitive = 0;
  return true;
}

SurfacePoint Sphere::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  // Pushed onto the sphere, the point is as exact as its coordinates can say.
  const Vec3 p = ray.At(hit.t);
  const Vec3 on_sphere = p * (radius_ / Length(p));
  return {on_sphere, Abs(on_sphere) * 6e-7f, on_sphere, on_sphere};
}

}  // namespace candela
