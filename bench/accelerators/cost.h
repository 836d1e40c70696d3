#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/cpu_seconds.h"

namespace candela {

struct BenchOptions {
  int repetitions = 3;
  int side = 64;           ///< Of the pictures.
  int triangles = 20'000;  ///< Of the meshes, about.
  bool update = false;
};

/// What an accelerator costs with a scene.
struct Cost {
  double build_ms = 0;
  uint64_t bytes = 0;
  std::vector<double> ray_ns;  ///< Of each set of rays.
};

/// The least seconds of several turns of `work`.
template <class Work>
double LeastSeconds(int repetitions, const Work& work) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < repetitions; ++i) {
    const double begin = CpuSeconds();
    work();
    least = std::min(least, CpuSeconds() - begin);
  }
  return least;
}

}  // namespace candela
