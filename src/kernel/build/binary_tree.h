#pragma once

#include <cstdint>
#include <span>

#include "kernel/build/fragment.h"
#include "kernel/record.h"

namespace candela::kernel {

/// A node of the binary tree that the wide one is made from.
struct alignas(32) BinaryNode {
  Float4 low;   ///< Fourth lane of an inner node: the pair of its children; of a leaf: its first.
  Float4 high;  ///< Fourth lane: the number of fragments below; of a leaf also its kind and a mark.

  BinaryNode() = default;
  static BinaryNode Inner(const Box4& box, uint32_t pair, uint32_t count) {
    return {box, pair, count};
  }
  static BinaryNode Leaf(const Box4& box, uint32_t first, uint32_t count, RecordKind kind) {
    return {box, first, count | static_cast<uint32_t>(kind) << kKindBit | kLeafMark};
  }

  Box4 Box() const { return {low, high}; }
  bool IsLeaf() const { return (FourthBits(high) & kLeafMark) != 0; }
  uint32_t Count() const { return FourthBits(high) & (IsLeaf() ? kLeafCount : ~0u); }
  RecordKind Kind() const {
    return static_cast<RecordKind>((FourthBits(high) & ~kLeafMark) >> kKindBit);
  }
  uint32_t First() const { return FourthBits(low); }
  uint32_t Pair() const { return FourthBits(low); }
  uint32_t Left() const { return 2 * Pair(); }
  uint32_t Right() const { return 2 * Pair() + 1; }

 private:
  static constexpr uint32_t kLeafMark = 1u << 31;
  static constexpr uint32_t kKindBit = 8;
  static constexpr uint32_t kLeafCount = (1u << kKindBit) - 1;

  BinaryNode(const Box4& box, uint32_t pair_or_first, uint32_t count)
      : low(WithFourthBits(box.low, pair_or_first)), high(WithFourthBits(box.high, count)) {}
};
static_assert(sizeof(BinaryNode) == 32);

/// A binary tree over fragments. Two siblings are a pair, nodes 2p and 2p + 1 in one cache line;
/// which number a pair has depends on the threads, so nothing may depend on that.
struct BinaryTree {
  static constexpr uint32_t kRoot = 0;

  PageArray<BinaryNode> nodes;
  Fragment* fragments = nullptr;  ///< A leaf has those from `First()` on, in ascending order.
  uint32_t most_pairs = 0;        ///< All pairs have smaller numbers. Nodes 0 and 1 are no pair.

  std::span<const Fragment> FragmentsOf(uint32_t leaf) const {
    return {fragments + nodes[leaf].First(), nodes[leaf].Count()};
  }
};

}  // namespace candela::kernel
