#include "kernel/build/binary_builder.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "base/check.h"
#include "base/parallel.h"
#include "kernel/build/partition.h"
#include "kernel/build/spatial_split.h"
#include "kernel/build/triangle_packer.h"

namespace candela::kernel {
namespace {

/// Splitting triangles is considered where the boxes of the two sides of an object split overlap by
/// more than these parts of the area of the whole, and of the range that is divided. As in Embree.
constexpr double kLeastOverlap = 1e-5;
constexpr double kLeastOwnOverlap = 0.2;

constexpr uint32_t kLeastToSplit = 8;

/// After so many tries that were not worth it, one below the other, there are no more.
constexpr uint32_t kMostVainTries = 3;

/// And made when it lowers the cost at least to this part of that of the object split.
constexpr float kLeastGain = 0.99f;

/// Marks the item of a fragment that goes to the right.
constexpr uint32_t kRightMark = 1u << 31;

/// Fragments [begin, end), still to be divided. There is room for new ones up to `limit`.
struct Range {
  uint32_t node;
  uint32_t begin, end, limit;
  uint32_t depth;
  uint32_t vain_tries;  ///< To split triangles, one after the other from here upwards.
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

/// Instead of a worker: all of them do it together.
constexpr int kAll = -1;

class Builder {
 public:
  Builder(const std::vector<BuildItem>& items, const FragmentList& list,
          const BinaryOptions& options, BinaryTree* tree)
      : items_(items),
        fragments_(tree->fragments),
        options_(options),
        tree_(*tree),
        task_size_(std::clamp(list.count / 32, 1024u, 2 * kChunkSize)),
        least_overlap_(kLeastOverlap * list.box.ToBounds().HalfArea()),
        pairs_(static_cast<size_t>(ThreadCount())) {
    // A split at most doubles a range, and no side of it is larger than the range was.
    for (int i = 0; i < ThreadCount(); ++i) scratch_.emplace_back(2 * task_size_ + kChunkSize);
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
      Divide(range, kAll, &left, &right);
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
    const std::span<const Fragment> fragments{fragments_ + range.begin, range.Count()};
    if (fragments.size() == 1) return true;
    if (fragments.size() > TrianglePacker::kMost) return false;
    const uint32_t number = fragments[0].Item();
    const BuildItem& item = items_[number];
    if (!item.triangles) return false;
    for (const Fragment& fragment : fragments) {
      if (fragment.Item() != number) return false;
    }
    // A leaf takes the same time for any number of triangles, so the more the better.
    if (fragments.size() <= 2) return true;  // At most 6 vertices.
    return TrianglePacker(item).Pack(fragments);
  }

  void MakeLeaf(const Range& range) {
    Fragment* const begin = fragments_ + range.begin;
    Fragment* end = fragments_ + range.end;
    std::sort(begin, end);
    // Two pieces of a triangle may have come together.
    end = std::unique(begin, end, [](const Fragment& a, const Fragment& b) {
      return a.Item() == b.Item() && a.Primitive() == b.Primitive();
    });
    tree_.nodes[range.node] = BinaryNode::Leaf(
        range.box, range.begin, static_cast<uint32_t>(end - begin), items_[begin->Item()].leaf);
  }

  /// Divides a range in two and makes its node. With more than a task all threads work on it.
  void Divide(const Range& range, int worker, Range* left, Range* right) {
    const uint32_t pair = pairs_.Take(std::max(worker, 0));
    tree_.nodes[range.node] = BinaryNode::Inner(range.box, pair, range.Count());
    left->node = 2 * pair;
    right->node = 2 * pair + 1;
    left->depth = right->depth = range.depth + 1;
    left->vain_tries = right->vain_tries = range.vain_tries;
    DivideFragments(range, worker, left, right);
    left->centers = CentersOf(*left, worker);
    right->centers = CentersOf(*right, worker);
  }

  void DivideFragments(const Range& range, int worker, Range* left, Range* right) {
    const BinMapping mapping(range.centers, range.Count());
    ObjectSplit split;
    if (range.depth < options_.halving_depth && mapping.IsUseful()) {
      Bins bins;
      FillBins(range, worker, mapping, &bins);
      split = bins.FindSplit(AreaScale(range.box));
      if (TrySpatialSplit(range, split, worker, left, right)) return;
    }
    uint32_t left_count = range.Count() / 2;
    if (split.IsFound()) {
      left_count = split.left_count;
      const auto border = static_cast<float>(split.bin);
      PartitionRange(range, worker, [&](const Fragment& fragment) {
        return mapping.IsBelow(fragment, split.axis, border);
      });
      left->box = split.left;
      right->box = split.right;
    } else {
      Halve(range);
      left->box = BoxOf(range.begin, range.begin + left_count);
      right->box = BoxOf(range.begin + left_count, range.end);
    }
    ShareRoom(range, left_count, left, right);
  }

  /// Divides the range by a spatial split when that is better than the object split.
  bool TrySpatialSplit(const Range& range, const ObjectSplit& object_split, int worker, Range* left,
                       Range* right) {
    if (!options_.split_triangles || range.limit == range.end) return false;
    if (range.Count() < kLeastToSplit || range.vain_tries == kMostVainTries) return false;
    if (object_split.IsFound()) {
      const Box4 overlap{Max(object_split.left.low, object_split.right.low),
                         Min(object_split.left.high, object_split.right.high)};
      const double area = overlap.ToBounds().HalfArea();
      if (area <= least_overlap_) return false;
      if (area <= kLeastOwnOverlap * range.box.ToBounds().HalfArea()) return false;
    }
    left->vain_tries = right->vain_tries = range.vain_tries + 1;
    const SlabMapping mapping(range.box);
    const SpatialSplit split = FindSpatialSplit(range, worker, mapping);
    const uint32_t count = split.left_count + split.right_count;
    if (!(split.cost < kLeastGain * object_split.cost) || count > range.limit - range.begin)
      return false;

    left->vain_tries = right->vain_tries = 0;
    Range both = range;
    both.end = range.begin + count;
    CutAndMark(range, mapping, split, both.end);
    PartitionRange(both, worker,
                   [](const Fragment& fragment) { return (fragment.Item() & kRightMark) == 0; });
    left->box = split.left;
    right->box = split.right;
    ShareRoom(both, split.left_count, left, right);
    ForEachChunk(right->Count(), [&](uint32_t, uint32_t from, uint32_t to, int) {
      for (uint32_t i = right->begin + from; i < right->begin + to; ++i) {
        Fragment& fragment = fragments_[i];
        fragment.low = WithFourthBits(fragment.low, fragment.Item() & ~kRightMark);
      }
    });
    return true;
  }

  SpatialSplit FindSpatialSplit(const Range& range, int worker, const SlabMapping& mapping) {
    const float area_scale = AreaScale(range.box);
    Fragment* const begin = fragments_ + range.begin;
    SpatialBins bins;
    if (worker != kAll) {
      bins.Add(begin, fragments_ + range.end, mapping, items_);
      return bins.FindSplit(area_scale);
    }
    std::vector<SpatialBins> parts(scratch_.size());
    ForEachChunk(range.Count(), [&](uint32_t, uint32_t from, uint32_t to, int part) {
      StopWhenCancelled(options_.cancel);
      parts[static_cast<size_t>(part)].Add(begin + from, begin + to, mapping, items_);
    });
    for (const SpatialBins& part : parts) bins.Merge(part);
    return bins.FindSplit(area_scale);
  }

  /// Marks what goes to the right, and cuts what goes to both sides: the right pieces are added
  /// behind the range, up to `new_end`.
  void CutAndMark(const Range& range, const SlabMapping& mapping, const SpatialSplit& split,
                  uint32_t new_end) {
    std::vector<std::vector<Fragment>> added((range.Count() + kChunkSize - 1) / kChunkSize);
    ForEachChunk(range.Count(), [&](uint32_t chunk, uint32_t from, uint32_t to, int) {
      StopWhenCancelled(options_.cancel);
      Pieces pieces(items_, mapping);
      for (uint32_t i = range.begin + from; i < range.begin + to; ++i) {
        Fragment& fragment = fragments_[i];
        pieces.Take(fragment);
        pieces.Cut(split.axis);
        if (pieces.last() < split.slab) continue;
        const uint32_t marked = fragment.Item() | kRightMark;
        if (pieces.first() >= split.slab) {
          fragment.low = WithFourthBits(fragment.low, marked);
          continue;
        }
        Box4 left, right;
        for (int slab = pieces.first(); slab <= pieces.last(); ++slab) {
          (slab < split.slab ? left : right).Extend(pieces[slab]);
        }
        added[chunk].emplace_back(right, marked, fragment.Primitive());
        fragment = Fragment(left, fragment.Item(), fragment.Primitive());
      }
    });
    Fragment* to = fragments_ + range.end;
    for (const std::vector<Fragment>& each : added) to = std::copy(each.begin(), each.end(), to);
    CHECK(to == fragments_ + new_end);
  }

  /// The two sides of a range get parts of its free room in proportion to their fragments.
  void ShareRoom(const Range& range, uint32_t left_count, Range* left, Range* right) {
    const uint32_t right_count = range.Count() - left_count;
    const uint64_t room = range.limit - range.end;
    const auto room_of_left = static_cast<uint32_t>(room * left_count / range.Count());
    left->begin = range.begin;
    left->end = left->begin + left_count;
    left->limit = right->begin = left->end + room_of_left;
    right->end = right->begin + right_count;
    right->limit = range.limit;
    // The right side moves up; as their order does not matter, its first ones move behind it.
    const uint32_t moved = std::min(room_of_left, right_count);
    std::copy_n(fragments_ + left->end, moved, fragments_ + right->end - moved);
  }

  void FillBins(const Range& range, int worker, const BinMapping& mapping, Bins* bins) {
    bins->Clear(mapping.bins);
    Fragment* const begin = fragments_ + range.begin;
    if (worker != kAll) {
      bins->Add(begin, fragments_ + range.end, mapping);
      return;
    }
    std::vector<Bins> parts(scratch_.size());
    for (Bins& part : parts) part.Clear(mapping.bins);
    ForEachChunk(range.Count(), [&](uint32_t, uint32_t from, uint32_t to, int part) {
      StopWhenCancelled(options_.cancel);
      parts[static_cast<size_t>(part)].Add(begin + from, begin + to, mapping);
    });
    for (const Bins& part : parts) bins->Merge(part);
  }

  template <class IsLeft>
  void PartitionRange(const Range& range, int worker, const IsLeft& is_left) {
    Fragment* const begin = fragments_ + range.begin;
    if (worker == kAll) {
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

  Box4 BoxOf(uint32_t begin, uint32_t end) const {
    Box4 box;
    for (uint32_t i = begin; i < end; ++i) box.Extend(fragments_[i].Box());
    return box;
  }

  Box4 CentersOf(const Range& range, int worker) const {
    const Fragment* const begin = fragments_ + range.begin;
    const auto centers_of = [begin](uint32_t from, uint32_t to) {
      Box4 centers;
      for (uint32_t i = from; i < to; ++i) centers.Extend(begin[i].Center());
      return centers;
    };
    if (worker != kAll) return centers_of(0, range.Count());
    std::vector<Box4> parts(scratch_.size());
    ForEachChunk(range.Count(), [&](uint32_t, uint32_t from, uint32_t to, int part) {
      parts[static_cast<size_t>(part)].Extend(centers_of(from, to));
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
  const double least_overlap_;
  PairNumbers pairs_;
  std::vector<PageArray<Fragment>> scratch_;  ///< For each worker.
};

}  // namespace

BinaryTree BuildBinaryTree(const std::vector<BuildItem>& items, FragmentList* list,
                           const BinaryOptions& options) {
  BinaryTree tree;
  tree.fragments = list->fragments.data();
  tree.most_pairs =
      static_cast<uint32_t>(PairNumbers::Most(list->capacity, static_cast<size_t>(ThreadCount())));
  tree.nodes = PageArray<BinaryNode>(2 * static_cast<size_t>(tree.most_pairs));
  Builder(items, *list, options, &tree)
      .Build({BinaryTree::kRoot, 0, list->count, list->capacity, 0, 0, list->box, list->centers});
  return tree;
}

}  // namespace candela::kernel
