#include "kernel/build/collapse.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "kernel/build/triangle_packer.h"

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

Collapse::Collapse(const std::vector<BuildItem>& items, BinaryTree* tree, const CancelToken* cancel)
    : items_(items), tree_(*tree), cancel_(cancel), choice_(tree->most_pairs) {}

double Collapse::LeafCost(uint32_t node) const {
  const BinaryNode& leaf = tree_.nodes[node];
  switch (items_[tree_.fragments[leaf.First()].Item()].leaf) {
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
  const double as_node = Area(inner) * kNodeCost + costs.in[kWidth];
  const double as_leaf = may_join_ ? CostOfJoining(node) : kImpossible;
  if (as_node < as_leaf) choice |= 1;
  costs.in[1] = std::min(as_node, as_leaf);
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
  may_join_ = false;
  width == 8 ? ChooseAll<8>() : ChooseAll<16>();
}

void Collapse::JoinLeaves() {
  may_join_ = true;
  ChooseAll<8>();
  JoinBelow(BinaryTree::kRoot, 1);
}

/// What it costs when all below the node becomes one leaf.
double Collapse::CostOfJoining(uint32_t node) const {
  const BinaryNode& inner = tree_.nodes[node];
  if (inner.Count() > PrimitiveLeaf::kMost) return kImpossible;
  Entries entries;
  CollectEntries(node, &entries);
  const uint32_t number = entries.entry[0].Item();
  const RecordKind kind = items_[number].leaf;
  if (kind == RecordKind::kPrimitives) {
    for (uint32_t i = 0; i < entries.count; ++i) {
      if (items_[entries.entry[i].Item()].leaf != kind) return kImpossible;
    }
    return Area(inner) * kPrimitiveCost * entries.count;
  }
  if (kind == RecordKind::kInstance) return kImpossible;
  for (uint32_t i = 0; i < entries.count; ++i) {
    if (entries.entry[i].Item() != number) return kImpossible;
  }
  if (!TrianglePacker(items_[number]).Pack({entries.entry, entries.count})) return kImpossible;
  return Area(inner) * kTriangleLeafCost;
}

/// The entries below a node, sorted, each once: two pieces of a triangle may have come together.
void Collapse::CollectEntries(uint32_t node, Entries* entries) const {
  CollectUnsorted(node, entries);
  Fragment* const begin = entries->entry;
  Fragment* const end = begin + entries->count;
  std::sort(begin, end);
  entries->count = static_cast<uint32_t>(std::unique(begin, end,
                                                     [](const Fragment& a, const Fragment& b) {
                                                       return a.Item() == b.Item() &&
                                                              a.Primitive() == b.Primitive();
                                                     }) -
                                         begin);
}

void Collapse::CollectUnsorted(uint32_t node, Entries* entries) const {
  const BinaryNode& binary = tree_.nodes[node];
  if (!binary.IsLeaf()) {
    CollectUnsorted(binary.Left(), entries);
    CollectUnsorted(binary.Right(), entries);
    return;
  }
  for (uint32_t i = 0; i < binary.Count(); ++i) {
    entries->entry[entries->count++] = tree_.fragments[binary.First() + i];
  }
}

/// Makes the leaves that were chosen below a node which has so many slots.
void Collapse::JoinBelow(uint32_t node, int slots) {
  BinaryNode& binary = tree_.nodes[node];
  if (binary.IsLeaf()) return;
  const uint64_t choice = choice_[binary.Pair()];
  while (slots > 1 && SlotsOfLeft(choice, slots) == 0) --slots;
  if (slots == 1) {
    if ((choice & 1) == 0) {
      MakeLeaf(node);
      return;
    }
    slots = 8;
  }
  const int slots_of_left = SlotsOfLeft(choice, slots);
  JoinBelow(binary.Left(), slots_of_left);
  JoinBelow(binary.Right(), slots - slots_of_left);
}

void Collapse::MakeLeaf(uint32_t node) {
  Entries entries;
  CollectEntries(node, &entries);
  uint32_t first = node;
  while (!tree_.nodes[first].IsLeaf()) first = tree_.nodes[first].Left();
  first = tree_.nodes[first].First();
  std::copy_n(entries.entry, entries.count, tree_.fragments + first);
  tree_.nodes[node] =
      BinaryNode(tree_.nodes[node].Box(), first, entries.count | BinaryNode::kLeafMark);
}

int Collapse::NodesInSlots(uint32_t node, int slots, uint32_t* to) const {
  const BinaryNode& binary = tree_.nodes[node];
  if (!binary.IsLeaf()) {
    const uint64_t choice = choice_[binary.Pair()];
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
  const int slots_of_left = SlotsOfLeft(choice_[inner.Pair()], width);
  const int count = NodesInSlots(inner.Left(), slots_of_left, to);
  return count + NodesInSlots(inner.Right(), width - slots_of_left, to + count);
}

}  // namespace candela::kernel
