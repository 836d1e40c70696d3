// Measures the accelerators with the course's scenes and with small forms of the meshes of
// bench/kernel. Prints a table of each.

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/parallel.h"
#include "cost.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "kernel/accelerator_kind.h"
#include "mesh_cost.h"
#include "scene_cost.h"
#include "support/document_table.h"
#include "support/run_bench.h"

namespace candela {
namespace {

constexpr const char* kName = "accelerator_bench";

/// Of one accelerator in one scene: each time of a ray, and how many times the tree's it is.
std::string Row(const std::string& scene, std::string_view accelerator, const Cost& cost,
                const Cost& bvh) {
  std::string row = fmt::format("| {:12} | {:6} | {:8.2f} | {:9.1f} |", scene, accelerator,
                                cost.build_ms, static_cast<double>(cost.bytes) / 1000);
  for (size_t i = 0; i < cost.ray_ns.size(); ++i) {
    row += fmt::format(" {:9.0f} | {:7.1f} |", cost.ray_ns[i], cost.ray_ns[i] / bvh.ray_ns[i]);
  }
  return row + "\n";
}

/// Rows of one scene for all accelerators.
Result<std::string> Rows(const std::string& scene, const CostOf& cost_of) {
  std::string rows;
  Cost bvh;
  for (const AcceleratorEntry& entry : Accelerators()) {
    const Result<Cost> cost = cost_of(entry.kind);
    if (!cost) return cost.error();
    if (entry.kind == AcceleratorKind::kBvh) bvh = *cost;
    rows += Row(scene, entry.name, *cost, bvh);
  }
  return rows;
}

Result<std::string> Tables(const BenchOptions& options) {
  std::string text =
      "| scene        |        | build ms | memory kB | ns to ray |  to bvh |\n"
      "|--------------|--------|---------:|----------:|----------:|--------:|\n";
  for (const testing_support::CourseScene& course : testing_support::kCourseScenes) {
    const std::string name = std::filesystem::path(course.file).stem().string().substr(5);
    const auto rows =
        Rows(name, [&](AcceleratorKind kind) { return CostOfScene(course, kind, options); });
    if (!rows) return rows.error();
    text += *rows;
  }
  text +=
      "\n"
      "| mesh         |        | build ms | memory kB |    camera |  to bvh | scattered |  to bvh "
      "|\n"
      "|--------------|--------|---------:|----------:|----------:|--------:|----------:|--------:|"
      "\n";
  const auto visited = ForEachMesh(options, [&](const std::string& mesh, const CostOf& cost_of) {
    const auto rows = Rows(mesh, cost_of);
    if (rows) text += *rows;
    return rows ? Result<void>() : rows.error();
  });
  if (!visited) return visited.error();
  return text;
}

Result<void> Run(const BenchOptions& options) {
  const ThreadLimit one_thread(1);
  const Result<std::string> tables = Tables(options);
  if (!tables) return tables.error();
  return Publish("accelerator bench", *tables, options.update);
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  ArgParser parser(kName,
                   "Measures the accelerators with the course's scenes and with meshes. Runs in "
                   "the root of the project.",
                   ArgStyle::kGnu);
  parser.Group("What is measured");
  parser.Option("repetitions", {Whole("N", &options.repetitions, 1, 1000)},
                "of which the best counts; the default is 3");
  parser.Option("size", {Whole("N", &options.side, 1, 10000)},
                "side of the pictures in pixels; the default is 64");
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
