#pragma once

#include <functional>
#include <string>

#include "base/result.h"
#include "cost.h"
#include "kernel/accelerator_kind.h"

namespace candela {

/// What an accelerator costs in some place.
using CostOf = std::function<Result<Cost>(AcceleratorKind accelerator)>;
/// Gets the name of each mesh, and what accelerators cost there.
using MeshVisitor = std::function<Result<void>(const std::string& mesh, const CostOf& cost_of)>;

/// Shows small forms of the meshes of bench/kernel, with rays from the camera and scattered ones.
Result<void> ForEachMesh(const BenchOptions& options, const MeshVisitor& visit);

}  // namespace candela
