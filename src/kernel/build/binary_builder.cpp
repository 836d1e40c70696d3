#include "kernel/build/binary_builder.h"

#include <algorithm>
#include <memory>

#include "base/parallel.h"
#include "kernel/build/triangle_packer.h"

namespace candela::kernel {
namespace {

/// Ranges of at most so many fragments are left to one thread: they fit its cache.
constexpr uint32_t kTaskSize = 32768;

/// Fragments [begin, end), still to be divided.
struct Range {
  uint32_t node;
  uint32_t begin, end;
  uint32_t depth;
  Box4 box, centers;

  uint32_t Count() const { return end - begin; }
};

class Builder {
 public:
  Builder(const std::vector<BuildItem>& items, Fragment* fragments, const BinaryOptions& options,
          BinaryTree* tree)
      : items_(items), fragments_(fragments), options_(options), tree_(*tree) {}

  void Build(const Range& root) {
    std::vector<Range> large = {root}, tasks;
    while (!large.empty()) {
      StopWhenCancelled(options_.cancel);
      const Range range = large.back();
      large.pop_back();
      if (range.Count() <= kTaskSize) {
        tasks.push_back(range);
        continue;
      }
      Range left, right;
      Divide(range, &left, &right);
      large.push_back(right);
      large.push_back(left);
    }
    ParallelFor(static_cast<int64_t>(tasks.size()), [&](int64_t i) {
      StopWhenCancelled(options_.cancel);
      BuildBelow(tasks[static_cast<size_t>(i)]);
    });
  }

 private:
  void BuildBelow(const Range& range) {
    if (IsLeaf(range)) {
      MakeLeaf(range);
      return;
    }
    Range left, right;
    Divide(range, &left, &right);
    BuildBelow(left);
    BuildBelow(right);
  }

  bool IsLeaf(const Range& range) const {
    if (range.Count() == 1) return true;
    if (options_.down_to_one || range.Count() > TrianglePacker::kMost) return false;
    const uint32_t number = fragments_[range.begin].Item();
    const BuildItem& item = items_[number];
    if (!item.triangles) return false;
    TrianglePacker packer(item);
    for (uint32_t i = range.begin; i < range.end; ++i) {
      if (fragments_[i].Item() != number || !packer.Add(fragments_[i].Primitive())) return false;
    }
    return true;
  }

  void MakeLeaf(const Range& range) {
    tree_.nodes[range.node] =
        BinaryNode(range.box, range.begin, range.Count() | BinaryNode::kLeafMark);
    for (uint32_t i = range.begin; i < range.end; ++i) {
      tree_.entries[i] = {fragments_[i].Item(), fragments_[i].Primitive()};
    }
    std::sort(&tree_.entries[range.begin], &tree_.entries[range.end]);
  }

  void Divide(const Range& range, Range* left, Range* right) {
    const BinMapping mapping(range.centers, range.Count());
    ObjectSplit split;
    if (range.depth < options_.halving_depth && mapping.IsUseful()) {
      Bins bins;
      bins.Clear(mapping.bins);
      bins.Add(fragments_ + range.begin, fragments_ + range.end, mapping);
      split = bins.FindSplit(AreaScale(range.box));
    }
    Fragment* const begin = fragments_ + range.begin;
    Fragment* const end = fragments_ + range.end;
    uint32_t middle;
    if (split.IsFound()) {
      const auto border = static_cast<float>(split.bin);
      Fragment* const at = std::partition(begin, end, [&](const Fragment& fragment) {
        return mapping.Position(fragment.Center())[split.axis] < border;
      });
      middle = static_cast<uint32_t>(at - fragments_);
    } else {
      middle = range.begin + range.Count() / 2;
      HalveByPosition(range, begin, end);
    }
    *left = {2 * middle, range.begin, middle, range.depth + 1, {}, {}};
    *right = {2 * middle + 1, middle, range.end, range.depth + 1, {}, {}};
    FindBoxes(left);
    FindBoxes(right);
    tree_.nodes[range.node] = BinaryNode(range.box, middle, range.Count());
  }

  /// For centres that coincide, or a tree that grows too deep: by position, then by number.
  void HalveByPosition(const Range& range, Fragment* begin, Fragment* end) const {
    const Float4 extent = range.centers.high - range.centers.low;
    const int axis = LargestAxis(ToVec3(extent));
    std::nth_element(begin, begin + range.Count() / 2, end,
                     [axis](const Fragment& a, const Fragment& b) {
                       const float at_a = a.Center()[axis], at_b = b.Center()[axis];
                       if (at_a != at_b) return at_a < at_b;
                       if (a.Item() != b.Item()) return a.Item() < b.Item();
                       return a.Primitive() < b.Primitive();
                     });
  }

  void FindBoxes(Range* range) const {
    for (uint32_t i = range->begin; i < range->end; ++i) {
      range->box.Extend(fragments_[i].Box());
      range->centers.Extend(fragments_[i].Center());
    }
  }

  const std::vector<BuildItem>& items_;
  Fragment* const fragments_;
  const BinaryOptions& options_;
  BinaryTree& tree_;
};

}  // namespace

BinaryTree BuildBinaryTree(const std::vector<BuildItem>& items, FragmentList* list,
                           const BinaryOptions& options) {
  BinaryTree tree;
  tree.capacity = list->count;
  tree.nodes = PageArray<BinaryNode>(2 * static_cast<size_t>(tree.capacity));
  tree.entries = PageArray<BinaryTree::Entry>(tree.capacity);
  Builder(items, list->fragments.data(), options, &tree)
      .Build({BinaryTree::kRoot, 0, list->count, 0, list->box, list->centers});
  return tree;
}

}  // namespace candela::kernel
