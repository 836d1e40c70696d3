#pragma once

#include <cstdint>
#include <span>

#include "kernel/build/build_items.h"
#include "kernel/build/fragment.h"
#include "kernel/record.h"

namespace candela::kernel {

/// Writes the leaf of some fragments, which are sorted, at a record; its triangles' ids go to
/// `triangle_ids[first_id...]`.
void WriteLeaf(const BuildItem& item, std::span<const Fragment> fragments, uint32_t first_id,
               Record* record, uint32_t* triangle_ids);

/// The leaf of an instance.
void WriteInstance(const BuildItem& item, uint32_t number, Record* record);

}  // namespace candela::kernel
