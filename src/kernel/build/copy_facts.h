#pragma once

#include <span>

#include "base/result.h"
#include "kernel/build/build_items.h"
#include "kernel/group_data.h"

namespace candela::kernel {

/// Fills in what searches know of the items of a group, whatever finds them, and how deep groups
/// nest below. Fails for instances that cannot be, when groups nest too deeply, and for more
/// primitives than can be numbered. `group` knows its width and its accelerator.
Result<void> CopyFacts(const GroupInput& input, std::span<const BuildItem> items, GroupData* group);

}  // namespace candela::kernel
