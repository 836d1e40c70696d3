#pragma once

#include <cstdint>
#include <span>

#include "kernel/build/binary_tree.h"
#include "kernel/build/build_items.h"
#include "kernel/record.h"

namespace candela::kernel {

/// Writes the leaf of some entries, which are sorted, at a record; its triangles' ids go to
/// `triangle_ids[first_id...]`.
void WriteLeaf(const BuildItem& item, std::span<const BinaryTree::Entry> entries, uint32_t first_id,
               Record* record, uint32_t* triangle_ids);

/// The leaf of an instance.
void WriteInstance(const BuildItem& item, uint32_t number, Record* record);

}  // namespace candela::kernel
