#pragma once

#include <cstdint>
#include <vector>

#include "base/cancel_token.h"
#include "base/result.h"
#include "kernel/build/binary_tree.h"
#include "kernel/build/build_items.h"
#include "kernel/build/collapse.h"
#include "kernel/group_data.h"

namespace candela::kernel {

/// One tree of a group: of what rests, or of what moves.
struct ChosenTree {
  const BinaryTree* binary;
  const Collapse* collapse;
};

/// Writes the trees (either may be null) as records: `records`, `root`, `triangle_ids`, `depth` and
/// `stack_need` of the group, whose `width` is set. A node stands before its children, its leaves
/// directly behind it. `extra_records` are left free at the end. Returns the stack entries of the
/// tree itself, without those of the groups inside. Fails when there are too many records.
Result<uint32_t> EmitTrees(const std::vector<BuildItem>& items, const ChosenTree* resting,
                           const ChosenTree* moving, uint32_t extra_records,
                           const CancelToken* cancel, GroupData* group);

}  // namespace candela::kernel
