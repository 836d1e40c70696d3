#include "shapes/shape.h"

namespace candela {

bool Shape::Occludes(const Ray& ray) const {
  HitRecord hit;
  hit.t = ray.t_max;
  return Intersect(ray, &hit);
}

std::unique_ptr<const SurfaceSampler> Shape::MakeSampler(const Transform&, const Transform&) const {
  return nullptr;
}

}  // namespace candela
