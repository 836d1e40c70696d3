#pragma once

#include <cstdint>
#include <vector>

#include "base/cancel_token.h"
#include "kernel/build/binary_tree.h"

namespace candela::kernel {

/// Chooses which nodes of a binary tree become children of one wide node, for the least expected
/// cost, by dynamic programming. Henri Ylitie, Tero Karras, Samuli Laine:
/// Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, 2017, section 4.1.
class Collapse {
 public:
  static constexpr int kMostChildren = 16;

  Collapse(const BinaryTree* tree, const CancelToken* cancel);

  /// Chooses for nodes of `width` children.
  void ChooseNodes(int width);

  /// Takes the same number of levels of the binary tree into each node, whatever it costs. From a
  /// tree that was halved again and again, this makes a flat one.
  void ChooseEvenly();

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

  double LeafCost(uint32_t node) const;
  uint64_t ChoiceOf(const BinaryNode& inner) const;

  const BinaryTree& tree_;
  const CancelToken* cancel_;
  /// By the pair of the node's children, 4 bits for each number of slots, from 1 on. The number of
  /// slots that the left child gets; 0 where one slot less is as good.
  PageArray<uint64_t> choice_;
  bool is_even_ = false;
};

}  // namespace candela::kernel
