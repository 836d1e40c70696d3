#include "kernel/build/collapse.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"

namespace candela::kernel {
namespace {

// In visits of a node. A whole leaf of triangles is tested at once.
constexpr double kNodeCost = 1;
constexpr double kTriangleLeafCost = 1;
constexpr double kPrimitiveCost = 2;
constexpr double kInstanceCost = 8;

constexpr double kImpossible = std::numeric_limits<double>::infinity();

/// Subtrees of at most so many fragments are one thread's work.
constexpr uint32_t kTaskSize = 32768;

double Area(const BinaryNode& node) {
  return node.Box().ToBounds().HalfArea();
}

int SlotsOfLeft(uint64_t choice, int slots) {
  return static_cast<int>(choice >> 4 * (slots - 1) & 15);
}

}  // namespace

/// `in[s]`: the least cost of a subtree that takes at most s slots of the node above.
template <int kWidth>
struct Collapse::Costs {
  double in[kWidth + 1];
};

Collapse::Collapse(const BinaryTree* tree, const CancelToken* cancel)
    : tree_(*tree), cancel_(cancel), choice_(tree->most_pairs) {}

double Collapse::LeafCost(uint32_t node) const {
  const BinaryNode& leaf = tree_.nodes[node];
  switch (leaf.Kind()) {
    case RecordKind::kPrimitives:
      return Area(leaf) * kPrimitiveCost * leaf.Count();
    case RecordKind::kInstance:
      return Area(leaf) * kInstanceCost;
    default:
      return Area(leaf) * kTriangleLeafCost;
  }
}

template <int kWidth>
Collapse::Costs<kWidth> Collapse::Join(uint32_t node, const Costs<kWidth>& left,
                                       const Costs<kWidth>& right) {
  Costs<kWidth> costs;
  uint64_t choice = 0;
  // Both sides together in s slots. The most even of equally good divisions is taken, which keeps
  // the tree flat.
  for (int slots = 2; slots <= kWidth; ++slots) {
    double best = kImpossible;
    int best_left = 0, best_unevenness = 0;
    for (int i = 1; i < slots; ++i) {
      const double cost = left.in[i] + right.in[slots - i];
      const int unevenness = std::abs(2 * i - slots);
      if (cost < best || (cost == best && unevenness < best_unevenness)) {
        best = cost;
        best_left = i;
        best_unevenness = unevenness;
      }
    }
    costs.in[slots] = best;
    choice |= static_cast<uint64_t>(best_left) << 4 * (slots - 1);
  }
  const BinaryNode& inner = tree_.nodes[node];
  costs.in[1] = Area(inner) * kNodeCost + costs.in[kWidth];
  for (int slots = 2; slots < kWidth; ++slots) {
    if (costs.in[1] > costs.in[slots]) continue;
    costs.in[slots] = costs.in[1];
    choice &= ~(uint64_t{15} << 4 * (slots - 1));
  }
  choice_[inner.Pair()] = choice;
  return costs;
}

template <int kWidth>
Collapse::Costs<kWidth> Collapse::CostsBelow(uint32_t node) {
  const BinaryNode& binary = tree_.nodes[node];
  if (binary.IsLeaf()) {
    Costs<kWidth> costs;
    std::fill_n(costs.in, kWidth + 1, LeafCost(node));
    return costs;
  }
  return Join<kWidth>(node, CostsBelow<kWidth>(binary.Left()), CostsBelow<kWidth>(binary.Right()));
}

template <int kWidth>
void Collapse::ChooseAll() {
  std::vector<uint32_t> tasks;
  FindTasks(BinaryTree::kRoot, &tasks);
  std::vector<Costs<kWidth>> costs(tasks.size());
  ParallelFor(static_cast<int64_t>(tasks.size()), [&](int64_t i) {
    StopWhenCancelled(cancel_);
    costs[static_cast<size_t>(i)] = CostsBelow<kWidth>(tasks[static_cast<size_t>(i)]);
  });
  const Costs<kWidth>* next = costs.data();
  CostsAbove<kWidth>(BinaryTree::kRoot, &next);
}

/// The tasks below a node, from left to right.
void Collapse::FindTasks(uint32_t node, std::vector<uint32_t>* tasks) const {
  const BinaryNode& binary = tree_.nodes[node];
  if (binary.IsLeaf() || binary.Count() <= kTaskSize) {
    tasks->push_back(node);
    return;
  }
  FindTasks(binary.Left(), tasks);
  FindTasks(binary.Right(), tasks);
}

/// Joins the results of the tasks, which it meets in the order of `FindTasks`.
template <int kWidth>
Collapse::Costs<kWidth> Collapse::CostsAbove(uint32_t node, const Costs<kWidth>** next) {
  const BinaryNode& binary = tree_.nodes[node];
  if (binary.IsLeaf() || binary.Count() <= kTaskSize) return *(*next)++;
  const Costs<kWidth> left = CostsAbove<kWidth>(binary.Left(), next);
  const Costs<kWidth> right = CostsAbove<kWidth>(binary.Right(), next);
  return Join<kWidth>(node, left, right);
}

void Collapse::ChooseNodes(int width) {
  width == 8 ? ChooseAll<8>() : ChooseAll<16>();
}

void Collapse::ChooseEvenly() {
  is_even_ = true;
}

uint64_t Collapse::ChoiceOf(const BinaryNode& inner) const {
  // 1 of 2 and 3 slots to the left, 2 of 4 and 5, and so on.
  constexpr uint64_t kHalves = 0x8776655443322110;
  return is_even_ ? kHalves : choice_[inner.Pair()];
}

int Collapse::NodesInSlots(uint32_t node, int slots, uint32_t* to) const {
  const BinaryNode& binary = tree_.nodes[node];
  if (!binary.IsLeaf()) {
    const uint64_t choice = ChoiceOf(binary);
    while (slots > 1 && SlotsOfLeft(choice, slots) == 0) --slots;
    if (slots > 1) {
      const int slots_of_left = SlotsOfLeft(choice, slots);
      const int count = NodesInSlots(binary.Left(), slots_of_left, to);
      return count + NodesInSlots(binary.Right(), slots - slots_of_left, to + count);
    }
  }
  *to = node;
  return 1;
}

int Collapse::ChildrenOf(uint32_t node, int width, uint32_t* to) const {
  const BinaryNode& inner = tree_.nodes[node];
  const int slots_of_left = SlotsOfLeft(ChoiceOf(inner), width);
  const int count = NodesInSlots(inner.Left(), slots_of_left, to);
  return count + NodesInSlots(inner.Right(), width - slots_of_left, to + count);
}

}  // namespace candela::kernel
