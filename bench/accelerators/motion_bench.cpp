// Measures what it costs that a mesh moves: rays at times that are spread over the shutter, with a
// mesh whose vertices move and with one that moves as a whole, beside the same mesh at rest. Prints
// one table.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "cost.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "geometry/bounds3.h"
#include "kernel/group.h"
#include "math/mat4.h"
#include "mesh_rays.h"
#include "meshes.h"
#include "support/document_table.h"
#include "support/run_bench.h"

namespace candela {
namespace {

constexpr const char* kName = "motion_bench";

/// A hundredth of the mesh's size.
Vec3 WayOf(const TriangleMesh& mesh) {
  Bounds3 box;
  for (const Vec3 p : mesh.positions) box.Extend(p);
  return box.Extent() * 0.01f;
}

using Built = Result<std::shared_ptr<const Group>>;

Built BuildOf(GroupItem item) {
  GroupInput input;
  input.push_back(std::move(item));
  auto group = Group::Build(std::move(input), {});
  if (!group) return group.error();
  return std::shared_ptr<const Group>(*std::move(group));
}

Built AtRest(const TriangleMesh& mesh) {
  return BuildOf({TriangleInput{mesh.positions, mesh.triangles}});
}

/// Every second vertex goes all of the way, the others half of it.
Built Deforming(const TriangleMesh& mesh, Vec3 way) {
  std::vector<Vec3> positions = mesh.positions;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    positions.push_back(mesh.positions[i] + way * (i % 2 == 0 ? 1.0f : 0.5f));
  }
  return BuildOf({TriangleInput{positions, mesh.triangles, 2}});
}

Built MovingNode(const std::shared_ptr<const Group>& mesh, Vec3 way) {
  const std::vector<Mat4> steps = {Mat4::Identity(), Mat4::Translate(ToDouble(way))};
  return BuildOf({InstanceInput{mesh, steps}});
}

/// At times that are spread evenly, in no order.
std::vector<Ray> AtTimes(std::vector<Ray> rays) {
  constexpr uint32_t kGolden = 2654435769;  // 2^32 over the golden ratio.
  uint32_t time = 0;
  for (Ray& ray : rays) ray.time = static_cast<float>((time += kGolden) >> 8) / (1 << 24);
  return rays;
}

Result<std::string> Rows(const SceneEntry& entry, const BenchOptions& bench) {
  const BenchScene scene = MakeScene(entry, bench.triangles / entry.triangles);
  const Vec3 way = WayOf(scene.mesh);
  const Built at_rest = AtRest(scene.mesh);
  if (!at_rest) return at_rest.error();
  const std::vector<Ray> camera = AtTimes(CameraRays(scene.view, bench.side));
  const std::vector<Ray> scattered = AtTimes(ScatteredRays(**at_rest, camera));

  const std::pair<const char*, Built> groups[] = {{"at rest", at_rest},
                                                  {"moving node", MovingNode(*at_rest, way)},
                                                  {"deforming mesh", Deforming(scene.mesh, way)}};
  std::string rows;
  double rest[2] = {};
  for (const auto& [name, group] : groups) {
    if (!group) return group.error();
    rows += fmt::format("| {:12} | {:14} |", entry.name, name);
    const std::vector<Ray>* sets[] = {&camera, &scattered};
    for (size_t i = 0; i < 2; ++i) {
      const double ns =
          NanosecondsPerRay(**group, RayOrder::kScattered, *sets[i], bench.repetitions);
      if (rest[i] == 0) rest[i] = ns;
      rows += fmt::format(" {:9.0f} | {:7.2f} |", ns, ns / rest[i]);
    }
    rows += "\n";
  }
  return rows;
}

Result<void> Run(const BenchOptions& bench) {
  const ThreadLimit one_thread(1);
  std::string text =
      "| mesh         |                | camera ns | to rest | scattered | to rest |\n"
      "|--------------|----------------|----------:|--------:|----------:|--------:|\n";
  for (const SceneEntry& entry : SceneEntries()) {
    if (!entry.in_summary || entry.triangles > 2e6) continue;
    const Result<std::string> rows = Rows(entry, bench);
    if (!rows) return rows.error();
    text += *rows;
  }
  return Publish("motion bench", text, bench.update);
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  options.side = 256;
  ArgParser parser(kName,
                   "Measures rays that meet moving meshes, beside the same meshes at rest. Runs in "
                   "the root of the project.",
                   ArgStyle::kGnu);
  parser.Group("What is measured");
  parser.Option("repetitions", {Whole("N", &options.repetitions, 1, 1000)},
                "of which the best counts; the default is 3");
  parser.Option("size", {Whole("N", &options.side, 1, 10000)},
                "side of the pictures in pixels; the default is 256");
  parser.Option("triangles", {Whole("N", &options.triangles, 1000, 1'000'000)},
                "of each mesh, about; the default is 20000");
  parser.Group("Results");
  parser.Flag("update", &options.update, "put the table into docs/performance.md");
  return RunBench(parser, words, [&] { return Run(options); });
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  return candela::Main(candela::WordsOf(argc, argv));
}
