#include "kernel/build/emit.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "base/parallel.h"
#include "kernel/build/leaf_writer.h"
#include "kernel/group.h"

namespace candela::kernel {
namespace {

/// Subtrees of at most so many fragments are one thread's work.
constexpr uint32_t kTaskSize = 16384;

/// Records and triangle ids: how many, or where the next ones go.
struct Place {
  uint64_t records = 0, ids = 0;

  Place& operator+=(const Place& other) {
    records += other.records;
    ids += other.ids;
    return *this;
  }
};

struct Subtree {
  Reference reference = 0;
  LinearBox box;            ///< Of a moving one.
  int depth = 0;            ///< Nodes on the longest way down.
  uint32_t need = 0;        ///< Entries on the stack of a search,
  uint32_t total_need = 0;  ///< and with those of the groups inside.
};

template <int kWidth>
class Emitter {
 public:
  using Children = std::array<uint32_t, kWidth>;

  Emitter(const std::vector<BuildItem>& items, const ChosenTree& tree, bool moving,
          const CancelToken* cancel)
      : items_(items),
        tree_(*tree.binary),
        collapse_(*tree.collapse),
        moving_(moving),
        cancel_(cancel) {}

  /// What the tree takes below a node that has these slots for it.
  Place Plan(int slots) {
    root_count_ = collapse_.NodesInSlots(BinaryTree::kRoot, slots, roots_.data());
    upper_ = {};
    PlanUpper({roots_.data(), static_cast<size_t>(root_count_)});
    ParallelFor(static_cast<int64_t>(tasks_.size()), [&](int64_t i) {
      StopWhenCancelled(cancel_);
      Task& task = tasks_[static_cast<size_t>(i)];
      task.size = SizeOf(task.node);
    });
    Place sum = upper_;
    for (const Task& task : tasks_) sum += task.size;
    return sum;
  }

  /// Writes all of it from a place on, and returns what the node above needs.
  int Emit(Place place, GroupData* group, uint32_t* nodes, Subtree* subtrees) {
    group_ = group;
    Place next = place;
    next += upper_;
    for (Task& task : tasks_) {
      task.place = next;
      next += task.size;
    }
    ParallelFor(static_cast<int64_t>(tasks_.size()), [&](int64_t i) {
      StopWhenCancelled(cancel_);
      Task& task = tasks_[static_cast<size_t>(i)];
      task.subtree = EmitNode(task.node, &task.place, false);
    });
    next_task_ = 0;
    std::copy_n(roots_.data(), root_count_, nodes);
    EmitChildren({nodes, static_cast<size_t>(root_count_)}, &place, true, subtrees);
    return root_count_;
  }

 private:
  struct Task {
    uint32_t node;
    Place size, place;
    Subtree subtree;
  };

  static constexpr uint64_t NodeRecords(bool moving) {
    return (moving ? sizeof(MovingNode<kWidth>) : sizeof(WideNode<kWidth>)) / sizeof(Record);
  }

  bool IsTask(uint32_t node) const { return tree_.nodes[node].Count() <= kTaskSize; }

  Place SizeOfLeaf(uint32_t leaf) const {
    const BuildItem& item = items_[tree_.fragments[tree_.nodes[leaf].First()].Item()];
    if (!item.triangles) return {1, 0};
    return {TriangleLeafRecords(item.steps), tree_.nodes[leaf].Count()};
  }

  Place SizeOf(uint32_t node) const {
    if (tree_.nodes[node].IsLeaf()) return SizeOfLeaf(node);
    Place sum{NodeRecords(moving_), 0};
    Children children;
    const int count = collapse_.ChildrenOf(node, kWidth, children.data());
    for (int i = 0; i < count; ++i) sum += SizeOf(children[static_cast<size_t>(i)]);
    return sum;
  }

  /// Finds the tasks, in the order in which `EmitChildren` meets them.
  void PlanUpper(std::span<const uint32_t> nodes) {
    for (const uint32_t node : nodes) {
      if (tree_.nodes[node].IsLeaf()) {
        upper_ += SizeOfLeaf(node);
      } else if (IsTask(node)) {
        tasks_.push_back({node, {}, {}, {}});
      } else {
        upper_.records += NodeRecords(moving_);
        Children children;
        const int count = collapse_.ChildrenOf(node, kWidth, children.data());
        PlanUpper({children.data(), static_cast<size_t>(count)});
      }
    }
  }

  /// Writes what stands behind a node, leaves first.
  void EmitChildren(std::span<const uint32_t> nodes, Place* place, bool upper, Subtree* subtrees) {
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (tree_.nodes[nodes[i]].IsLeaf()) subtrees[i] = EmitLeaf(nodes[i], place);
    }
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (tree_.nodes[nodes[i]].IsLeaf()) continue;
      subtrees[i] = upper && IsTask(nodes[i]) ? tasks_[next_task_++].subtree
                                              : EmitNode(nodes[i], place, upper);
    }
  }

  Subtree EmitLeaf(uint32_t leaf, Place* place) {
    const auto fragments = tree_.FragmentsOf(leaf);
    const BuildItem& item = items_[fragments[0].Item()];
    const Place size = SizeOfLeaf(leaf);
    Subtree subtree;
    subtree.reference = MakeReference(item.leaf, static_cast<uint32_t>(place->records));
    Record* const record = group_->records.data() + place->records;
    WriteLeaf(item, fragments, static_cast<uint32_t>(place->ids), record,
              group_->triangle_ids.data());
    *place += size;
    if (item.instance) subtree.total_need = 1 + item.instance->group->data().stack_need;
    if (moving_) {
      for (const Fragment& fragment : fragments) {
        LinearBox box;
        LinearBoxOf(item, fragment.Primitive(), &box);
        subtree.box.Extend(box);
      }
    }
    return subtree;
  }

  Subtree EmitNode(uint32_t node, Place* place, bool upper) {
    const auto record = static_cast<uint32_t>(place->records);
    place->records += NodeRecords(moving_);
    Children children;
    Subtree subtrees[kWidth];
    const int count = collapse_.ChildrenOf(node, kWidth, children.data());
    EmitChildren({children.data(), static_cast<size_t>(count)}, place, upper, subtrees);
    void* const to = group_->records.data() + record;
    Subtree subtree = Sum(subtrees, count);
    if (moving_) {
      WriteMovingNode(subtrees, count, static_cast<MovingNode<kWidth>*>(to));
      subtree.reference = MakeReference(RecordKind::kMovingNode, record);
    } else {
      auto* const wide = static_cast<WideNode<kWidth>*>(to);
      for (int i = 0; i < count; ++i) {
        SetChild(i, tree_.nodes[children[static_cast<size_t>(i)]].Box(), subtrees[i].reference,
                 wide);
      }
      for (int i = count; i < kWidth; ++i) SetChild(i, Box4{}, 0, wide);
      subtree.reference = MakeReference(RecordKind::kNode, record);
    }
    return subtree;
  }

 public:
  /// A node over some subtrees, without its reference.
  static Subtree Sum(const Subtree* subtrees, int count) {
    Subtree sum;
    for (int i = 0; i < count; ++i) {
      sum.box.Extend(subtrees[i].box);
      sum.depth = std::max(sum.depth, subtrees[i].depth);
      sum.need = std::max(sum.need, subtrees[i].need);
      sum.total_need = std::max(sum.total_need, subtrees[i].total_need);
    }
    sum.depth += 1;
    sum.need += static_cast<uint32_t>(count - 1);
    sum.total_need += static_cast<uint32_t>(count - 1);
    return sum;
  }

  static void SetChild(int i, const Box4& box, Reference reference, WideNode<kWidth>* node) {
    for (int axis = 0; axis < 3; ++axis) {
      node->box[2 * axis][i] = box.low[axis];
      node->box[2 * axis + 1][i] = box.high[axis];
    }
    node->child[i] = reference;
  }

 private:
  static void WriteMovingNode(const Subtree* subtrees, int count, MovingNode<kWidth>* node) {
    for (int i = 0; i < kWidth; ++i) {
      const Subtree child = i < count ? subtrees[i] : Subtree{};
      for (int end = 0; end < 2; ++end) {
        for (int axis = 0; axis < 3; ++axis) {
          node->box[end][2 * axis][i] = child.box.at[end].low[axis];
          node->box[end][2 * axis + 1][i] = child.box.at[end].high[axis];
        }
      }
      node->child[i] = child.reference;
    }
  }

  const std::vector<BuildItem>& items_;
  const BinaryTree& tree_;
  const Collapse& collapse_;
  const bool moving_;
  const CancelToken* const cancel_;
  GroupData* group_ = nullptr;

  int root_count_ = 0;
  Children roots_;
  Place upper_;
  std::vector<Task> tasks_;
  size_t next_task_ = 0;
};

template <int kWidth>
Result<uint32_t> EmitWide(const std::vector<BuildItem>& items, const ChosenTree* resting,
                          const ChosenTree* moving, uint32_t extra_records,
                          const CancelToken* cancel, GroupData* group) {
  using NodeEmitter = Emitter<kWidth>;
  constexpr uint64_t kNodeRecords = sizeof(WideNode<kWidth>) / sizeof(Record);
  const bool both = resting && moving;
  std::optional<NodeEmitter> emitters[2];
  Place sizes[2];
  if (resting)
    sizes[0] = emitters[0].emplace(items, *resting, false, cancel).Plan(both ? kWidth - 1 : 1);
  if (moving) sizes[1] = emitters[1].emplace(items, *moving, true, cancel).Plan(1);

  Place size{both ? kNodeRecords : 0, 0};
  const Place start = size;
  size += sizes[0];
  size += sizes[1];
  const uint64_t records = size.records + extra_records;
  if (records > kMostRecords) {
    return Error{ErrorCode::kResources,
                 "the scene is too large: one group can have 64 GiB of triangles and nodes"};
  }
  group->records = Arena(records);
  group->triangle_ids.resize(size.ids);

  uint32_t nodes[kWidth];
  Subtree subtrees[kWidth];
  int count = 0;
  Place place = start;
  for (int i = 0; i < 2; ++i) {
    if (!emitters[i]) continue;
    count += emitters[i]->Emit(place, group, nodes + count, subtrees + count);
    place += sizes[i];
  }
  Subtree root;
  if (both) {
    root = NodeEmitter::Sum(subtrees, count);
    root.reference = MakeReference(RecordKind::kNode, 0);
    auto* const wide = reinterpret_cast<WideNode<kWidth>*>(group->records.data());
    for (int i = 0; i < kWidth; ++i) {
      Box4 box;
      if (i < count - 1) box = resting->binary->nodes[nodes[i]].Box();
      if (i == count - 1) {
        box = subtrees[i].box.at[0];
        box.Extend(subtrees[i].box.at[1]);
      }
      NodeEmitter::SetChild(i, box, i < count ? subtrees[i].reference : 0, wide);
    }
  } else {
    root = subtrees[0];
  }
  group->root = root.reference;
  group->depth = root.depth;
  group->stack_need = root.total_need;
  return root.need;
}

}  // namespace

Result<uint32_t> EmitTrees(const std::vector<BuildItem>& items, const ChosenTree* resting,
                           const ChosenTree* moving, uint32_t extra_records,
                           const CancelToken* cancel, GroupData* group) {
  return (group->width == 8 ? EmitWide<8> : EmitWide<16>)(items, resting, moving, extra_records,
                                                          cancel, group);
}

}  // namespace candela::kernel
