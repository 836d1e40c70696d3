#include "shapes/shape.h"

namespace candela {

bool Shape::Occludes(const Ray& ray) const {
  HitRecord hit;
  hit.t = ray.t_max;
  return Intersect(ray, &hit);
}

}  // namespace candela
