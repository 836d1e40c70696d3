#include "mesh_cost.h"

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "kernel/group.h"
#include "mesh_rays.h"
#include "meshes.h"

namespace candela {
namespace {

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
  const std::vector<Ray> scattered = ScatteredRays(**group, camera);
  cost.ray_ns = {NanosecondsPerRay(**group, RayOrder::kCoherent, camera, options.repetitions),
                 NanosecondsPerRay(**group, RayOrder::kScattered, scattered, options.repetitions)};
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
