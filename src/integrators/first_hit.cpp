#include "integrators/first_hit.h"

#include <vector>

#include "integrators/shutter_times.h"

namespace candela {

void FindFirstHits(const Scene& scene, std::span<const Vec2> image_points,
                   std::span<FirstHit> first_hits) {
  std::vector<Ray> rays;
  const float time = scene.IsMoving() ? scene.camera().shutter().TimeOf(0.5f) : 0;
  rays.reserve(image_points.size());
  for (const Vec2 image_point : image_points) {
    rays.push_back(CameraRayAt(scene, time, image_point));
  }
  std::vector<HitRecord> hits(rays.size());
  scene.Intersect(RayOrder::kCoherent, rays, hits);
  for (size_t i = 0; i < rays.size(); ++i) {
    first_hits[i] = hits[i].IsHit()
                        ? FirstHit{true, scene.ShadingAt(rays[i], hits[i]).n_shading, hits[i].t}
                        : FirstHit();
  }
}

}  // namespace candela
