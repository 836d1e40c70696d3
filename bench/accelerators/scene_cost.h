#pragma once

#include "base/result.h"
#include "cost.h"
#include "kernel/accelerator_kind.h"
#include "tests/support/render_scene.h"

namespace candela {

/// With all rays of a picture: from the camera, to the lights, and along the mirrors.
Result<Cost> CostOfScene(const testing_support::CourseScene& course, AcceleratorKind accelerator,
                         const BenchOptions& options);

}  // namespace candela
