#include "mesh_rays.h"

#include <algorithm>

#include "cost.h"
#include "math/elementary.h"
#include "math/frame.h"

namespace candela {

std::vector<Ray> CameraRays(const View& view, int side) {
  const Frame frame = Frame::FromNormal(Normalize(view.look_at - view.eye));
  const double angle = double{view.fov_degrees} * kPi / 360;
  const auto half = static_cast<float>(Sin(angle) / Cos(angle));
  std::vector<Ray> rays;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float u = half * (2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(side) - 1);
      const float v = half * (2 * (static_cast<float>(y) + 0.5f) / static_cast<float>(side) - 1);
      rays.emplace_back(view.eye, Normalize(frame.ToWorld({u, v, 1})));
    }
  }
  return rays;
}

std::vector<Ray> ScatteredRays(const Group& group, const std::vector<Ray>& camera_rays) {
  std::vector<Vec3> points;
  for (const Ray& ray : camera_rays) {
    HitRecord hit;
    if (group.Intersect(ray, &hit)) points.push_back(ray.At(hit.t));
  }
  std::vector<Ray> rays;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 direction = points[(i * 7919 + 1) % points.size()] - points[i];
    if (!(Length(direction) > 0)) continue;
    rays.emplace_back(points[i], Normalize(direction));
    rays.back().t_min = 1e-4f;
  }
  return rays;
}

double NanosecondsPerRay(const Group& group, RayOrder order, const std::vector<Ray>& rays,
                         int repetitions) {
  std::vector<HitRecord> hits(rays.size());
  const double seconds = LeastSeconds(repetitions, [&] {
    std::ranges::fill(hits, HitRecord());
    group.Intersect(order, rays, hits);
  });
  return 1e9 * seconds / static_cast<double>(std::max<size_t>(rays.size(), 1));
}

}  // namespace candela
