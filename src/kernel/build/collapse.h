#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/cancel_token.h"
#include "kernel/build/binary_tree.h"
#include "kernel/build/build_items.h"

namespace candela::kernel {

/// Chooses which nodes of a binary tree become children of one wide node, and which become leaves,
/// for the least expected cost, by dynamic programming. Henri Ylitie, Tero Karras, Samuli Laine:
/// Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, 2017, section 4.1.
class Collapse {
 public:
  static constexpr int kMostChildren = 16;

  Collapse(const std::vector<BuildItem>& items, BinaryTree* tree, const CancelToken* cancel);

  /// For a tree down to single fragments: makes leaves of what may well be one, by the costs of
  /// nodes of 8.
  void JoinLeaves();

  /// Chooses for nodes of `width` children.
  void ChooseNodes(int width);

  /// The nodes that stand for `node` among the children of a wide node where there are `slots` for
  /// it. Returns how many were written to `to`.
  int NodesInSlots(uint32_t node, int slots, uint32_t* to) const;

  /// The children of the wide node for `node`.
  int ChildrenOf(uint32_t node, int width, uint32_t* to) const;

 private:
  template <int kWidth>
  struct Costs;
  template <int kWidth>
  Costs<kWidth> CostsBelow(uint32_t node);
  template <int kWidth>
  Costs<kWidth> Join(uint32_t node, const Costs<kWidth>& left, const Costs<kWidth>& right);
  template <int kWidth>
  Costs<kWidth> CostsAbove(uint32_t node, const Costs<kWidth>** next);
  template <int kWidth>
  void ChooseAll();
  void FindTasks(uint32_t node, std::vector<uint32_t>* tasks) const;

  struct Entries {
    uint32_t count = 0;
    Fragment entry[PrimitiveLeaf::kMost];
  };
  double LeafCost(uint32_t node) const;
  double CostOfJoining(uint32_t node) const;
  void CollectEntries(uint32_t node, Entries* entries) const;
  void CollectUnsorted(uint32_t node, Entries* entries) const;
  void JoinBelow(uint32_t node, int slots);
  void MakeLeaf(uint32_t node);

  const std::vector<BuildItem>& items_;
  BinaryTree& tree_;
  const CancelToken* cancel_;
  bool may_join_ = false;
  /// By the pair of the node's children, 4 bits for each number of slots, from 1 on. The number of
  /// slots that the left child gets; 0 where one slot less is as good. For one slot: 0 a leaf, 1 a
  /// node.
  PageArray<uint64_t> choice_;
};

}  // namespace candela::kernel
