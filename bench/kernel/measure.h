#pragma once

#include <vector>

#include "base/result.h"
#include "bench_scene.h"
#include "embree_scene.h"
#include "results.h"

namespace candela {

struct MeasureOptions {
  std::vector<RaySet> sets;
  int side = 512;       ///< Of the picture; its square is the number of rays of a set.
  int repetitions = 7;  ///< Of each mode with each set.
  int builds = 3;       ///< Of each tree; 0: builds are not timed.
};

/// Measures both kernels with a scene. Name, memory and speed are filled in.
Result<SceneResult> MeasureScene(const BenchScene& scene, const EmbreeDevice& device,
                                 const MeasureOptions& options);

}  // namespace candela
