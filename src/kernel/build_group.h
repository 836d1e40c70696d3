#pragma once

#include "base/result.h"
#include "kernel/group.h"
#include "kernel/group_data.h"
#include "kernel/group_input.h"

namespace candela::kernel {

/// Builds the tree of a group with nodes of `width` children (8 or 16), on all threads. The result
/// depends on the input, the quality and the width alone. Fields `isa` and `trace` are left to the
/// caller. Throws std::bad_alloc; fails with `kStopped` and `kResources`.
Result<GroupData> BuildGroup(const GroupInput& input, BuildQuality quality, int width,
                             const CancelToken* cancel);

/// See `Group::Refit`.
Result<void> RefitGroup(const GroupInput& input, GroupData* group);

}  // namespace candela::kernel
