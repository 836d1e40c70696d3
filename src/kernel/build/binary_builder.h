#pragma once

#include "base/cancel_token.h"
#include "kernel/build/binary_tree.h"
#include "kernel/build/binning.h"
#include "kernel/build/build_items.h"

namespace candela::kernel {

struct BinaryOptions {
  /// Whether triangles may be split, as far as there is room for their pieces.
  bool split_triangles = false;
  /// From this depth on ranges are halved, which adds at most the logarithm of their size.
  uint32_t halving_depth = 64;
  const CancelToken* cancel = nullptr;
};

/// Builds a tree, top down. Large ranges are divided by all threads together, one range after the
/// other; then each thread takes whole ranges. What a range is divided into depends on the set of
/// its fragments alone, never on their order, and so not on the threads. The list is reordered.
BinaryTree BuildBinaryTree(const std::vector<BuildItem>& items, FragmentList* list,
                           const BinaryOptions& options);

}  // namespace candela::kernel
