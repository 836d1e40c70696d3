#pragma once

#include <compare>
#include <cstdint>

#include "kernel/build/fragment.h"

namespace candela::kernel {

/// A node of the binary tree that the wide one is made from.
struct alignas(32) BinaryNode {
  Float4 low;   ///< Fourth lane of an inner node: its split; of a leaf: its first entry.
  Float4 high;  ///< Fourth lane: the number of fragments below, or of entries; and the mark.

  static constexpr uint32_t kLeafMark = 1u << 31;

  BinaryNode() = default;
  BinaryNode(const Box4& box, uint32_t split_or_first, uint32_t count_and_mark)
      : low(WithFourthBits(box.low, split_or_first)),
        high(WithFourthBits(box.high, count_and_mark)) {}

  Box4 Box() const { return {low, high}; }
  bool IsLeaf() const { return (FourthBits(high) & kLeafMark) != 0; }
  uint32_t Count() const { return FourthBits(high) & ~kLeafMark; }
  uint32_t First() const { return FourthBits(low); }
  uint32_t Split() const { return FourthBits(low); }
  uint32_t Left() const { return 2 * Split(); }
  uint32_t Right() const { return 2 * Split() + 1; }
};
static_assert(sizeof(BinaryNode) == 32);

/// A binary tree over fragments. Each inner node divides a range of places for fragments; no two of
/// them at the same place, its split. So the split says where the two children are stored (side by
/// side, in one cache line), threads need not agree on it, and it numbers the inner nodes.
struct BinaryTree {
  struct Entry {
    uint32_t item, primitive;

    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  static constexpr uint32_t kRoot = 0;

  PageArray<BinaryNode> nodes;
  PageArray<Entry> entries;
  uint32_t capacity = 0;  ///< Places; all splits are below, and above 0.
};

}  // namespace candela::kernel
