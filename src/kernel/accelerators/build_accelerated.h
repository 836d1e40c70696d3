#pragma once

#include "base/result.h"
#include "kernel/group.h"
#include "kernel/group_data.h"

namespace candela::kernel {

/// Builds a group whose hits are found by an accelerator other than the kernel's tree. Ready for
/// queries. Throws std::bad_alloc; fails as `Group::Build` does.
Result<GroupData> BuildAccelerated(const GroupInput& input, const BuildOptions& options);

}  // namespace candela::kernel
