#include "integrators/first_hit.h"

namespace candela {

FirstHit FindFirstHit(const Scene& scene, Vec2 image_point) {
  const Ray ray = scene.camera().GenerateRay(image_point);
  HitRecord hit;
  if (!scene.Intersect(ray, &hit)) return {};
  return {true, scene.ShadingAt(ray, hit).n_shading, hit.t};
}

}  // namespace candela
