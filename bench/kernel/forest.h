#pragma once

#include "bench_scene.h"

namespace candela {

/// 10,000 instances of one tree on rolling ground; `triangles` of all of them together.
BenchScene Forest(double triangles);

}  // namespace candela
