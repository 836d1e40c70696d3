#include "shapes/rectangle.h"

#include <cmath>

namespace candela {

std::shared_ptr<const Shape> Rectangle::Create(ParamReader* params, ShapeContext*) {
  const float width = params->RequiredPositive("width");
  const float height = params->RequiredPositive("height");
  return std::make_unique<Rectangle>(width, height);
}

Bounds3 Rectangle::ObjectBounds() const {
  return {{-half_width_, -half_height_, 0}, {half_width_, half_height_, 0}};
}

// The ray meets the plane z = 0 where o.z + t d.z = 0.
bool Rectangle::Intersect(const Ray& ray, HitRecord* hit) const {
  if (ray.direction.z == 0) return false;  // Parallel: it is seen edge-on.

  const float t = -ray.origin.z / ray.direction.z;
  if (!(t >= ray.t_min && t < hit->t)) return false;  // Written so that NaN is a miss.
  const Vec3 p = ray.At(t);
  if (!(std::abs(p.x) <= half_width_ && std::abs(p.y) <= half_height_)) return false;

  hit->t = t;
  hit->u = p.x;
  hit->v = p.y;
  hit->primitive = 0;
  return true;
}

SurfacePoint Rectangle::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  // In its plane the point is exact; along it, t, the product and the sum were rounded.
  Vec3 error = (Abs(ray.origin) + Abs(ray.direction * hit.t)) * 2e-7f;
  error.z = 0;
  const Vec3 n{0, 0, 1};
  return {{hit.u, hit.v, 0}, error, n, n};
}

// From 0 to 1 along either side.
void Rectangle::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  const float width = 2 * half_width_, height = 2 * half_height_;
  point->uv = {0.5f + hit.u / width, 0.5f + hit.v / height};
  point->dpdu = {width, 0, 0};
  point->dpdv = {0, height, 0};
}

}  // namespace candela
