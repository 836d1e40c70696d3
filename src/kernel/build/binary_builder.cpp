#include "kernel/build/binary_builder.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "base/parallel.h"
#include "kernel/build/partition.h"
#include "kernel/build/triangle_packer.h"

namespace candela::kernel {
namespace {

/// Fragments [begin, end), still to be divided.
struct Range {
  uint32_t node;
  uint32_t begin, end;
  uint32_t depth;
  Box4 box, centers;

  uint32_t Count() const { return end - begin; }
};

/// Numbers for pairs of nodes: blocks of them for each worker, so that a part of the tree stands
/// together, and the memory that is used as well.
class PairNumbers {
 public:
  explicit PairNumbers(size_t workers) : next_(workers, 1), end_(workers, 1) {}

  static size_t Most(size_t pairs, size_t workers) { return 1 + pairs + kBlock * workers; }

  uint32_t Take(int worker) {
    uint32_t& next = next_[static_cast<size_t>(worker)];
    uint32_t& end = end_[static_cast<size_t>(worker)];
    if (next == end) {
      next = next_block_.fetch_add(kBlock, std::memory_order_relaxed);
      end = next + kBlock;
    }
    return next++;
  }

 private:
  static constexpr uint32_t kBlock = 1024;

  std::atomic<uint32_t> next_block_ = 1;
  std::vector<uint32_t> next_, end_;
};

class Builder {
 public:
  Builder(const std::vector<BuildItem>& items, const FragmentList& list,
          const BinaryOptions& options, BinaryTree* tree)
      : items_(items),
        fragments_(tree->fragments),
        options_(options),
        tree_(*tree),
        task_size_(std::clamp(list.count / 32, 1024u, 2 * kChunkSize)),
        pairs_(static_cast<size_t>(ThreadCount())) {
    for (int i = 0; i < ThreadCount(); ++i) scratch_.emplace_back(task_size_ + kChunkSize);
  }

  void Build(const Range& root) {
    std::vector<Range> large = {root}, tasks;
    while (!large.empty()) {
      StopWhenCancelled(options_.cancel);
      const Range range = large.back();
      large.pop_back();
      if (range.Count() <= task_size_) {
        tasks.push_back(range);
        continue;
      }
      Range left, right;
      Divide(range, 0, &left, &right);
      large.push_back(right);
      large.push_back(left);
    }
    ParallelForWorkers(static_cast<int64_t>(tasks.size()), [&](int64_t i, int worker) {
      StopWhenCancelled(options_.cancel);
      BuildBelow(tasks[static_cast<size_t>(i)], worker);
    });
  }

 private:
  void BuildBelow(const Range& range, int worker) {
    if (IsLeaf(range)) {
      MakeLeaf(range);
      return;
    }
    Range left, right;
    Divide(range, worker, &left, &right);
    BuildBelow(left, worker);
    BuildBelow(right, worker);
  }

  bool IsLeaf(const Range& range) const {
    if (range.Count() == 1) return true;
    if (options_.down_to_one || range.Count() > TrianglePacker::kMost) return false;
    const uint32_t number = fragments_[range.begin].Item();
    const BuildItem& item = items_[number];
    if (!item.triangles) return false;
    for (uint32_t i = range.begin + 1; i < range.end; ++i) {
      if (fragments_[i].Item() != number) return false;
    }
    return TrianglePacker(item).Pack({fragments_ + range.begin, range.Count()});
  }

  void MakeLeaf(const Range& range) {
    tree_.nodes[range.node] =
        BinaryNode(range.box, range.begin, range.Count() | BinaryNode::kLeafMark);
    std::sort(fragments_ + range.begin, fragments_ + range.end);
  }

  /// Divides a range in two and makes its node. With more than a task all threads work on it.
  void Divide(const Range& range, int worker, Range* left, Range* right) {
    const BinMapping mapping(range.centers, range.Count());
    ObjectSplit split;
    if (range.depth < options_.halving_depth && mapping.IsUseful()) {
      Bins bins;
      FillBins(range, mapping, &bins);
      split = bins.FindSplit(AreaScale(range.box));
    }
    const uint32_t pair = pairs_.Take(worker);
    tree_.nodes[range.node] = BinaryNode(range.box, pair, range.Count());
    *left = {2 * pair, range.begin, 0, range.depth + 1, {}, {}};
    *right = {2 * pair + 1, 0, range.end, range.depth + 1, {}, {}};
    if (split.IsFound()) {
      PartitionRange(range, worker,
                     [&, border = static_cast<float>(split.bin)](const Fragment& fragment) {
                       return mapping.IsBelow(fragment, split.axis, border);
                     });
      left->end = right->begin = range.begin + split.left_count;
      left->box = split.left;
      right->box = split.right;
    } else {
      left->end = right->begin = range.begin + range.Count() / 2;
      Halve(range);
      left->box = BoxOfRange(*left);
      right->box = BoxOfRange(*right);
    }
    left->centers = CentersOf(*left);
    right->centers = CentersOf(*right);
  }

  bool IsLarge(const Range& range) const { return range.Count() > task_size_; }

  void FillBins(const Range& range, const BinMapping& mapping, Bins* bins) {
    bins->Clear(mapping.bins);
    Fragment* const begin = fragments_ + range.begin;
    if (!IsLarge(range)) {
      bins->Add(begin, fragments_ + range.end, mapping);
      return;
    }
    std::vector<Bins> parts(scratch_.size());
    for (Bins& part : parts) part.Clear(mapping.bins);
    ForEachChunk(range.Count(), [&](uint32_t, uint32_t from, uint32_t to, int worker) {
      StopWhenCancelled(options_.cancel);
      parts[static_cast<size_t>(worker)].Add(begin + from, begin + to, mapping);
    });
    for (const Bins& part : parts) bins->Merge(part);
  }

  template <class IsLeft>
  void PartitionRange(const Range& range, int worker, const IsLeft& is_left) {
    Fragment* const begin = fragments_ + range.begin;
    if (IsLarge(range)) {
      PartitionParallel(begin, range.Count(), scratch_, is_left);
    } else {
      Partition(begin, fragments_ + range.end, scratch_[static_cast<size_t>(worker)].data(),
                is_left);
    }
  }

  /// For centres that coincide, or a tree that grows too deep: by position, then by number.
  void Halve(const Range& range) const {
    const int axis = LargestAxis(ToVec3(range.centers.high - range.centers.low));
    Fragment* const begin = fragments_ + range.begin;
    std::nth_element(begin, begin + range.Count() / 2, fragments_ + range.end,
                     [axis](const Fragment& a, const Fragment& b) {
                       const float at_a = a.Center(axis), at_b = b.Center(axis);
                       return at_a != at_b ? at_a < at_b : a < b;
                     });
  }

  Box4 BoxOfRange(const Range& range) const {
    Box4 box;
    for (uint32_t i = range.begin; i < range.end; ++i) box.Extend(fragments_[i].Box());
    return box;
  }

  Box4 CentersOf(const Range& range) const {
    const Fragment* const begin = fragments_ + range.begin;
    const auto centers_of = [begin](uint32_t from, uint32_t to) {
      Box4 centers;
      for (uint32_t i = from; i < to; ++i) centers.Extend(begin[i].Center());
      return centers;
    };
    if (!IsLarge(range)) return centers_of(0, range.Count());
    std::vector<Box4> parts(scratch_.size());
    ForEachChunk(range.Count(), [&](uint32_t, uint32_t from, uint32_t to, int worker) {
      parts[static_cast<size_t>(worker)].Extend(centers_of(from, to));
    });
    Box4 centers;
    for (const Box4& part : parts) centers.Extend(part);
    return centers;
  }

  const std::vector<BuildItem>& items_;
  Fragment* const fragments_;
  const BinaryOptions& options_;
  BinaryTree& tree_;
  const uint32_t task_size_;
  PairNumbers pairs_;
  std::vector<PageArray<Fragment>> scratch_;  ///< For each worker.
};

}  // namespace

BinaryTree BuildBinaryTree(const std::vector<BuildItem>& items, FragmentList* list,
                           const BinaryOptions& options) {
  BinaryTree tree;
  tree.fragments = list->fragments.data();
  tree.most_pairs =
      static_cast<uint32_t>(PairNumbers::Most(list->count, static_cast<size_t>(ThreadCount())));
  tree.nodes = PageArray<BinaryNode>(2 * static_cast<size_t>(tree.most_pairs));
  Builder(items, *list, options, &tree)
      .Build({BinaryTree::kRoot, 0, list->count, 0, list->box, list->centers});
  return tree;
}

}  // namespace candela::kernel
