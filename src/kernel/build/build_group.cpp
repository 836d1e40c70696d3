#include "kernel/build_group.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <string>

#include "base/check.h"
#include "kernel/build/binary_builder.h"
#include "kernel/build/collapse.h"
#include "kernel/build/copy_facts.h"
#include "kernel/build/emit.h"
#include "kernel/build/leaf_writer.h"

namespace candela::kernel {
namespace {

/// Room for pieces of triangles: so many times the number of triangles.
constexpr double kGrowth = 1.6;

/// A binary tree, and what becomes of it.
struct ChosenNodes {
  BinaryTree tree;
  std::optional<Collapse> collapse;
};

class GroupBuilder {
 public:
  GroupBuilder(const GroupInput& input, BuildQuality quality, int width, const CancelToken* cancel)
      : input_(input), items_(MakeBuildItems(input)), quality_(quality), cancel_(cancel) {
    group_.width = width;
  }

  Result<GroupData> Build() {
    if (const auto facts = CopyFacts(input_, items_, &group_); !facts) return facts.error();
    // Usually the first tree is it. One that a search would need a large stack for is built again,
    // flatter: at last simply halved, down from the root.
    FragmentList lists[2];
    uint32_t need = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
      for (int i = 0; i < 2; ++i) {
        lists[i] = CollectFragments(items_, i == 1, SplitsTriangles(i) ? kGrowth : 1, cancel_);
      }
      const uint32_t most = std::max(lists[0].count, lists[1].count);
      const auto levels = static_cast<uint32_t>(std::bit_width(most));
      const uint32_t halving_depth = attempt == 0 ? 64 : attempt == 1 ? levels + 8 : 0;
      const Result<uint32_t> result = BuildTrees(lists, halving_depth);
      if (!result) return result.error();
      need = *result;
      if (need <= kMostTreeStack) break;
    }
    group_.bounds = lists[0].bounds;
    group_.bounds.Extend(lists[1].bounds);
    CHECK(need <= kMostTreeStack);
    WriteUnbounded(lists);
    ListEntries();
    if (group_.stack_need > kMostSearchStack) {
      return Error{ErrorCode::kResources,
                   "too many instances without bounds: a search would need too much memory"};
    }
    return std::move(group_);
  }

 private:
  Result<uint32_t> BuildTrees(FragmentList* lists, uint32_t halving_depth) {
    ChosenNodes nodes[2];
    ChosenTree trees[2];
    const ChosenTree* present[2] = {nullptr, nullptr};
    for (int i = 0; i < 2; ++i) {
      if (lists[i].count == 0) continue;
      BinaryOptions options;
      options.halving_depth = halving_depth;
      options.split_triangles = SplitsTriangles(i);
      options.cancel = cancel_;
      nodes[i].tree = BuildBinaryTree(items_, &lists[i], options);
      Collapse& collapse = nodes[i].collapse.emplace(&nodes[i].tree, cancel_);
      if (halving_depth > 0) {
        collapse.ChooseNodes(group_.width);
      } else {
        collapse.ChooseEvenly();
      }
      trees[i] = {&nodes[i].tree, &collapse};
      present[i] = &trees[i];
    }
    if (!present[0] && !present[1]) {
      group_.records = Arena(UnboundedRecords(lists));
      return uint32_t{0};
    }
    return EmitTrees(items_, present[0], present[1], UnboundedRecords(lists), cancel_, &group_);
  }

  /// Only of what rests: the pieces of a moving triangle would have to be cut at all times.
  bool SplitsTriangles(int list) const { return quality_ == BuildQuality::kBest && list == 0; }

  uint32_t UnboundedRecords(const FragmentList* lists) const {
    uint32_t primitives = 0, records = 0;
    for (int i = 0; i < 2; ++i) {
      for (const FragmentList::Unbounded& each : lists[i].unbounded) {
        items_[each.item].instance ? ++records : ++primitives;
      }
    }
    return records + (primitives + PrimitiveLeaf::kMost - 1) / PrimitiveLeaf::kMost;
  }

  /// The last records.
  void WriteUnbounded(const FragmentList* lists) {
    auto record = static_cast<uint32_t>(group_.records.size()) - UnboundedRecords(lists);
    std::vector<Fragment> primitives;
    for (int i = 0; i < 2; ++i) {
      for (const FragmentList::Unbounded& each : lists[i].unbounded) {
        const BuildItem& item = items_[each.item];
        if (!item.instance) {
          primitives.push_back({Box4{}, each.item, each.primitive});
          continue;
        }
        WriteInstance(item, each.item, group_.records.data() + record);
        group_.unbounded.push_back(MakeReference(RecordKind::kInstance, record++));
        group_.stack_need =
            std::max(group_.stack_need, 1 + item.instance->group->data().stack_need);
      }
    }
    for (size_t i = 0; i < primitives.size(); i += PrimitiveLeaf::kMost) {
      const size_t count = std::min<size_t>(PrimitiveLeaf::kMost, primitives.size() - i);
      WriteLeaf(items_[primitives[i].Item()], {&primitives[i], count}, 0,
                group_.records.data() + record, nullptr);
      group_.unbounded.push_back(MakeReference(RecordKind::kPrimitives, record++));
    }
  }

  void ListEntries() {
    const auto add = [this](Reference reference) {
      const bool is_first = KindOf(reference) == RecordKind::kPrimitives;
      (is_first ? group_.first_primitives : group_.entries).push_back(reference);
    };
    if (group_.root != GroupData::kNothing) add(group_.root);
    for (const Reference reference : group_.unbounded) add(reference);
    // They stand there together, below what any of them needs.
    group_.stack_need += static_cast<uint32_t>(group_.entries.size());
  }

  const GroupInput& input_;
  const std::vector<BuildItem> items_;
  const BuildQuality quality_;
  const CancelToken* const cancel_;
  GroupData group_;
};

}  // namespace

Result<GroupData> BuildGroup(const GroupInput& input, BuildQuality quality, int width,
                             const CancelToken* cancel) {
  CHECK(width == 8 || width == 16);
  try {
    return GroupBuilder(input, quality, width, cancel).Build();
  } catch (const BuildStopped&) {
    return Error{ErrorCode::kStopped, "stopped on request"};
  }
}

}  // namespace candela::kernel
