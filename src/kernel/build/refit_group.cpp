#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "base/check.h"
#include "base/parallel.h"
#include "kernel/build/build_items.h"
#include "kernel/build/triangle_packer.h"
#include "kernel/build_group.h"

namespace candela::kernel {
namespace {

/// Nodes on the way to a subtree that is one thread's work.
constexpr int TaskDepth(int width) {
  return width == 8 ? 3 : 2;
}

bool IsSame(Vec3 a, Vec3 b) {
  return std::memcmp(&a, &b, sizeof(Vec3)) == 0;
}

/// Walks the tree twice: first everything is checked, then everything is changed.
template <int kWidth>
class Refitter {
 public:
  Refitter(const GroupInput& input, GroupData* group)
      : input_(input), items_(MakeBuildItems(input)), group_(*group) {}

  Result<void> Refit() {
    if (!SameItems()) return OtherItems();
    for (size_t i = 0; i < input_.size(); ++i) {
      if (!items_[i].instance) continue;
      const auto usable = CheckInstance(input_[i], *items_[i].instance, group_);
      if (!usable) return usable;
    }
    std::vector<Reference> tasks;
    if (group_.root != GroupData::kNothing) FindTasks(group_.root, 0, &tasks);
    std::vector<Problem> problems(tasks.size());
    ParallelFor(static_cast<int64_t>(tasks.size()), [&](int64_t i) {
      problems[static_cast<size_t>(i)] = CheckBelow(tasks[static_cast<size_t>(i)]);
    });
    const auto worst = std::max_element(problems.begin(), problems.end());
    if (worst != problems.end() && *worst != kNone) return ErrorOf(*worst);

    std::vector<LinearBox> boxes(tasks.size());  // Before anything is changed, which may not fail.
    CopyInstances();
    ParallelFor(static_cast<int64_t>(tasks.size()), [&](int64_t i) {
      boxes[static_cast<size_t>(i)] = FitBelow(tasks[static_cast<size_t>(i)]);
    });
    LinearBox whole;
    const LinearBox* next = boxes.data();
    if (group_.root != GroupData::kNothing) whole = FitAbove(group_.root, 0, &next);
    whole.at[0].Extend(whole.at[1]);
    group_.bounds = whole.at[0].ToBounds();
    return {};
  }

 private:
  enum Problem { kNone, kOtherItems, kApart, kUnbounded };

  static Error OtherItems() {
    return {ErrorCode::kUsage, "a group can only be refitted to the same items, of the same size"};
  }

  static Error ErrorOf(Problem problem) {
    switch (problem) {
      case kApart:
        return {ErrorCode::kUsage,
                "vertices that had the same position when the group was built do not have it any "
                "more; build the group again"};
      case kUnbounded:
        return {ErrorCode::kUsage,
                "something that was bounded when the group was built is not any more; build the "
                "group again"};
      default:
        return OtherItems();
    }
  }

  bool SameItems() const {
    if (input_.size() != group_.items.size()) return false;
    for (size_t i = 0; i < input_.size(); ++i) {
      const ItemFacts& facts = group_.items[i];
      const InstanceInput* const instance = items_[i].instance;
      if (facts.set != items_[i].set || facts.count != items_[i].count) return false;
      if (facts.group != (instance ? instance->group : nullptr)) return false;
      const size_t steps = instance && items_[i].steps > 1 ? items_[i].steps : 0;
      if (facts.motion.steps().size() != steps) return false;
    }
    return true;
  }

  template <class T>
  T& At(Reference reference) {
    return *reinterpret_cast<T*>(group_.records.data() + RecordOf(reference));
  }

  template <class Visit>
  void ForEachChild(Reference reference, const Visit& visit) {
    const auto visit_children = [&](const auto& node) {
      for (int i = 0; i < kWidth; ++i) {
        // Children that are not there have no reference other than that of the root, which nothing
        // but they can have.
        if (node.child[i] != 0) visit(i, node.child[i]);
      }
    };
    if (KindOf(reference) == RecordKind::kNode) visit_children(At<WideNode<kWidth>>(reference));
    if (KindOf(reference) == RecordKind::kMovingNode) {
      visit_children(At<MovingNode<kWidth>>(reference));
    }
  }

  static bool IsInner(Reference reference) {
    return KindOf(reference) == RecordKind::kNode || KindOf(reference) == RecordKind::kMovingNode;
  }
  static bool IsTask(Reference reference, int depth) {
    return depth == TaskDepth(kWidth) || !IsInner(reference);
  }

  void FindTasks(Reference reference, int depth, std::vector<Reference>* tasks) {
    if (IsTask(reference, depth)) {
      tasks->push_back(reference);
      return;
    }
    ForEachChild(reference, [&](int, Reference child) { FindTasks(child, depth + 1, tasks); });
  }

  Problem CheckBelow(Reference reference) {
    Problem worst = kNone;
    switch (KindOf(reference)) {
      case RecordKind::kTriangles:
      case RecordKind::kCheckedTriangles:
        return CheckTriangles(At<TriangleLeaf>(reference));
      case RecordKind::kPrimitives:
      case RecordKind::kInstance:
        return CheckBoxes(reference);
      default:
        ForEachChild(reference,
                     [&](int, Reference child) { worst = std::max(worst, CheckBelow(child)); });
        return worst;
    }
  }

  Problem CheckTriangles(const TriangleLeaf& leaf) const {
    const BuildItem& item = items_[leaf.item];
    if (!item.triangles || leaf.steps != item.steps) return kOtherItems;
    uint32_t vertex[8];
    uint32_t known = 0;
    for (int i = 0; leaf.lanes >> i != 0; ++i) {
      const uint32_t triangle = group_.triangle_ids[leaf.first + static_cast<uint32_t>(i)];
      if (triangle >= item.count) return kOtherItems;
      for (int corner = 0; corner < 3; ++corner) {
        const uint32_t here = item.triangles->triangles[triangle][static_cast<size_t>(corner)];
        const uint32_t place = leaf.Corner(corner, i);
        if (here >= item.vertex_count) return kOtherItems;
        if ((known >> place & 1) == 0) vertex[place] = here;
        known |= 1u << place;
        for (uint32_t step = 0; vertex[place] != here && step < item.steps; ++step) {
          if (!IsSame(item.Position(step, here), item.Position(step, vertex[place]))) return kApart;
        }
      }
    }
    return kNone;
  }

  Problem CheckBoxes(Reference reference) {
    Problem worst = kNone;
    ForEachEntry(reference, [&](const BuildItem& item, uint32_t primitive) {
      LinearBox box;
      if (primitive >= item.count) {
        worst = std::max(worst, kOtherItems);
      } else if (BoxAtAllTimes(item, primitive, &box) == BoxState::kUnbounded) {
        worst = kUnbounded;
      }
    });
    return worst;
  }

  /// Visits what is in a leaf of primitives or an instance.
  template <class Visit>
  void ForEachEntry(Reference reference, const Visit& visit) {
    if (KindOf(reference) == RecordKind::kInstance) {
      visit(items_[At<InstanceLeaf>(reference).item], 0u);
      return;
    }
    const auto& leaf = At<PrimitiveLeaf>(reference);
    for (uint32_t i = 0; i < leaf.count; ++i) {
      visit(items_[leaf.entry[i].item], leaf.entry[i].primitive);
    }
  }

  static BoxState BoxAtAllTimes(const BuildItem& item, uint32_t primitive, LinearBox* box) {
    if (item.IsMoving()) return LinearBoxOf(item, primitive, box);
    const BoxState state = BoxOf(item, primitive, &box->at[0]);
    box->at[1] = box->at[0];
    return state;
  }

  void CopyInstances() {
    for (size_t i = 0; i < input_.size(); ++i) {
      const InstanceInput* const instance = items_[i].instance;
      if (instance && items_[i].IsMoving()) {
        group_.items[i].motion = MovingInverse(instance->world_from_group);
      }
    }
    for (const Reference reference : group_.unbounded) {
      if (KindOf(reference) == RecordKind::kInstance) FitInstance(reference);
    }
  }

  void FitInstance(Reference reference) {
    auto& leaf = At<InstanceLeaf>(reference);
    const auto inverse = InverseAffine(items_[leaf.item].instance->world_from_group[0]);
    CHECK(inverse);
    leaf.group_from_world = Transform(*inverse);
  }

  LinearBox FitBelow(Reference reference) {
    LinearBox box;
    switch (KindOf(reference)) {
      case RecordKind::kTriangles:
      case RecordKind::kCheckedTriangles:
        return FitTriangles(&At<TriangleLeaf>(reference));
      case RecordKind::kInstance:
        FitInstance(reference);
        [[fallthrough]];
      case RecordKind::kPrimitives:
        ForEachEntry(reference, [&](const BuildItem& item, uint32_t primitive) {
          LinearBox each;
          if (BoxAtAllTimes(item, primitive, &each) == BoxState::kBox) box.Extend(each);
        });
        return box;
      default:
        ForEachChild(reference, [&](int i, Reference child) {
          const LinearBox below = FitBelow(child);
          SetBox(reference, i, below);
          box.Extend(below);
        });
        return box;
    }
  }

  /// The same for the nodes above the tasks, whose boxes come in the order of `FindTasks`.
  LinearBox FitAbove(Reference reference, int depth, const LinearBox** next) {
    if (IsTask(reference, depth)) return *(*next)++;
    LinearBox box;
    ForEachChild(reference, [&](int i, Reference child) {
      const LinearBox below = FitAbove(child, depth + 1, next);
      SetBox(reference, i, below);
      box.Extend(below);
    });
    return box;
  }

  LinearBox FitTriangles(TriangleLeaf* leaf) const {
    const BuildItem& item = items_[leaf->item];
    LinearBox box;
    uint32_t vertex[8];
    uint32_t used = 0;
    for (int i = 0; leaf->lanes >> i != 0; ++i) {
      const uint32_t triangle = group_.triangle_ids[leaf->first + static_cast<uint32_t>(i)];
      for (int corner = 0; corner < 3; ++corner) {
        const uint32_t place = leaf->Corner(corner, i);
        vertex[place] = item.triangles->triangles[triangle][static_cast<size_t>(corner)];
        used |= 1u << place;
      }
      LinearBox each;
      if (BoxAtAllTimes(item, triangle, &each) == BoxState::kBox) box.Extend(each);
    }
    for (uint32_t step = 0; step < item.steps; ++step) {
      VertexRows& rows = RowsOfStep(leaf, step);
      for (uint32_t i = 0; i < 8; ++i) {
        Vec3 position = item.Position(step, vertex[(used >> i & 1) != 0 ? i : 0]);
        // No comparison holds for a NaN, so triangles with a corner that is not finite are missed.
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        if (!IsFinite(position)) position = {kNan, kNan, kNan};
        for (int axis = 0; axis < 3; ++axis) rows[axis][i] = position[axis];
      }
    }
    return box;
  }

  void SetBox(Reference reference, int i, const LinearBox& box) {
    if (KindOf(reference) == RecordKind::kMovingNode) {
      auto& node = At<MovingNode<kWidth>>(reference);
      for (int end = 0; end < 2; ++end) SetRows(node.box[end], i, box.at[end]);
      return;
    }
    Box4 always = box.at[0];
    always.Extend(box.at[1]);
    SetRows(At<WideNode<kWidth>>(reference).box, i, always);
  }

  static void SetRows(float (&rows)[kBoxRows][kWidth], int i, const Box4& box) {
    for (int axis = 0; axis < 3; ++axis) {
      rows[2 * axis][i] = box.low[axis];
      rows[2 * axis + 1][i] = box.high[axis];
    }
  }

  const GroupInput& input_;
  const std::vector<BuildItem> items_;
  GroupData& group_;
};

}  // namespace

Result<void> RefitGroup(const GroupInput& input, GroupData* group) {
  return group->width == 8 ? Refitter<8>(input, group).Refit() : Refitter<16>(input, group).Refit();
}

}  // namespace candela::kernel
