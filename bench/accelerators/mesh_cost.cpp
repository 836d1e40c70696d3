#include "mesh_cost.h"

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "kernel/group.h"
#include "math/frame.h"
#include "meshes.h"

namespace candela {
namespace {

/// From the pinhole of a view, row by row.
std::vector<Ray> CameraRays(const View& view, int side) {
  const Frame frame = Frame::FromNormal(Normalize(view.look_at - view.eye));
  const float half = 0.466f;  // The tangent of half of 50 degrees.
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

/// From where other rays hit to where they do not agree on: each towards the hit of another one.
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

double NanosecondsPerRay(const Group& group, const std::vector<Ray>& rays, int repetitions) {
  std::vector<HitRecord> hits(rays.size());
  const double seconds = LeastSeconds(repetitions, [&] {
    std::ranges::fill(hits, HitRecord());
    group.Intersect(RayOrder::kScattered, rays, hits);
  });
  return 1e9 * seconds / static_cast<double>(std::max<size_t>(rays.size(), 1));
}

Result<Cost> CostOfMesh(const BenchScene& scene, AcceleratorKind accelerator,
                        const BenchOptions& options) {
  BuildOptions build;
  build.accelerator = accelerator;
  const auto make = [&] {
    return Group::Build({GroupItem{TriangleInput{scene.mesh.positions, scene.mesh.triangles}}},
                        build);
  };
  const auto group = make();
  if (!group) return group.error();
  Cost cost;
  cost.build_ms = 1000 * LeastSeconds(options.repetitions, [&] { CHECK(make().ok()); });
  cost.bytes = (*group)->MemoryBytes();
  const std::vector<Ray> camera = CameraRays(scene.view, options.side);
  for (const auto& rays : {camera, ScatteredRays(**group, camera)}) {
    cost.ray_ns.push_back(NanosecondsPerRay(**group, rays, options.repetitions));
  }
  return cost;
}

}  // namespace

Result<void> ForEachMesh(const BenchOptions& options, const MeshVisitor& visit) {
  for (const SceneEntry& entry : SceneEntries()) {
    if (!entry.in_summary || entry.triangles > 2e6) continue;
    const BenchScene scene = MakeScene(entry, options.triangles / entry.triangles);
    const auto cost_of = [&](AcceleratorKind kind) { return CostOfMesh(scene, kind, options); };
    if (auto visited = visit(std::string(entry.name), cost_of); !visited) return visited;
  }
  return {};
}

}  // namespace candela
