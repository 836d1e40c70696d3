#include "scene_cost.h"

#include <filesystem>
#include <vector>

#include "base/cancel_token.h"
#include "base/check.h"
#include "base/diagnostics.h"
#include "integrators/whitted.h"
#include "loaders/course/scene_parser.h"
#include "render/render_job.h"
#include "scene/compile_scene.h"

namespace candela {
namespace {

RenderOptions PictureOf(int side) {
  RenderOptions options;
  options.width = options.height = side;
  options.crop = {0, 0, side, side};
  return options;
}

}  // namespace

Result<Cost> CostOfScene(const testing_support::CourseScene& course, AcceleratorKind accelerator,
                         const BenchOptions& options) {
  Diagnostics diagnostics;
  const SceneSpec spec =
      LoadScene(std::filesystem::path("assets/assignment4") / course.file, &diagnostics);
  CompileOptions compilation;
  compilation.accelerator = accelerator;
  const auto scene = CompileScene(spec, &diagnostics, compilation);
  if (!scene) return diagnostics.FirstError().error();

  // Built again, since compiling reads pictures, too. No mesh of these scenes is an instance.
  const std::vector<Mat4> places(scene->objects().size(), Mat4::Identity());
  Cost cost;
  cost.bytes = scene->tree().MemoryBytes();
  cost.build_ms = 1000 * LeastSeconds(options.repetitions, [&] {
                    CHECK(BuildSceneTree(scene->objects(), places, accelerator).ok());
                  });

  const WhittedIntegrator integrator(*scene, course.bounces, course.shadows);
  const RenderOptions picture = PictureOf(options.side);
  uint64_t rays = 0;
  const double seconds = LeastSeconds(options.repetitions, [&] {
    RenderJob job(integrator, picture);
    CHECK(job.Run(CancelToken()));
    rays = job.Rays().Total();
  });
  cost.ray_ns = {1e9 * seconds / static_cast<double>(rays)};
  return cost;
}

}  // namespace candela
