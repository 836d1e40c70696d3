#include "shapes/disk.h"

namespace candela {

std::shared_ptr<const Shape> Disk::Create(ParamReader* params, ShapeContext*) {
  return std::make_unique<Disk>(params->RequiredPositive("radius"));
}

Bounds3 Disk::ObjectBounds() const {
  return {{-radius_, -radius_, 0}, {radius_, radius_, 0}};
}

// The ray meets the plane z = 0 where o.z + t d.z = 0.
bool Disk::Intersect(const Ray& ray, HitRecord* hit) const {
  if (ray.direction.z == 0) return false;  // Parallel: the disk is seen edge-on.

  const float t = -ray.origin.z / ray.direction.z;
  if (!(t >= ray.t_min && t < hit->t)) return false;  // Written so that NaN is a miss.

  // The squares are exact in double, so that no hit lies outside the bounds.
  const Vec3d p = ToDouble(ray.At(t));
  if (!(p.x * p.x + p.y * p.y <= double{radius_} * radius_)) return false;

  hit->t = t;
  hit->u = static_cast<float>(p.x);
  hit->v = static_cast<float>(p.y);
  hit->primitive = 0;
  return true;
}

SurfacePoint Disk::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  // In its plane the point is exact; along it, t, the product and the sum were rounded.
  Vec3 error = (Abs(ray.origin) + Abs(ray.direction * hit.t)) * 2e-7f;
  error.z = 0;
  const Vec3 n{0, 0, 1};
  return {{hit.u, hit.v, 0}, error, n, n};
}

// Those of the square around it: a picture is cut out, not bent.
void Disk::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  const float size = 2 * radius_;
  point->uv = {0.5f + hit.u / size, 0.5f + hit.v / size};
  point->dpdu = {size, 0, 0};
  point->dpdv = {0, size, 0};
}

}  // namespace candela
