#pragma once

#include <functional>
#include <string>

#include "base/result.h"
#include "cost.h"
#include "kernel/accelerator_kind.h"

namespace candela {

/// A name, and what an accelerator costs there.
using CostOf = std::function<Result<Cost>(AcceleratorKind accelerator)>;
using MeshVisitor = std::function<Result<void>(const std::string& mesh, const CostOf& cost_of)>;

/// Shows small forms of the meshes of bench/kernel, with rays from the camera and scattered ones.
Result<void> ForEachMesh(const BenchOptions& options, const MeshVisitor& visit);

}  // namespace candela
