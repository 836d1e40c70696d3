#include "kernel/accelerators/octree.h"

#include <algorithm>
#include <utility>

#include "kernel/accelerators/entry_search.h"
#include "kernel/build/fragment.h"

namespace candela::kernel {
namespace {

/// Lists up to here are left as they are.
constexpr size_t kFewEntries = 8;
/// A cell is not cut when its parts together would list more than this many times what it does.
constexpr size_t kMostGrowth = 3;
/// Nor when all lists together would be more than this many times as long as there are entries, or
/// longer than their places can be counted.
constexpr uint64_t kMostListed = 16;
constexpr uint64_t kMostPlaces = 0xFFFFFFFF;

bool Reaches(const Bounds3& box, const Octree::Cube& cube) {
  for (int axis = 0; axis < 3; ++axis) {
    if (static_cast<double>(box.max[axis]) < cube.low[axis]) return false;
    if (static_cast<double>(box.min[axis]) > cube.high[axis]) return false;
  }
  return true;
}

}  // namespace

// Neighbours share the plane between them to the bit, so nothing can lie in between.
Octree::Cube Octree::Cube::Part(uint32_t part) const {
  Cube cube = *this;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = low[axis] + (high[axis] - low[axis]) / 2;
    (part >> axis & 1 ? cube.low : cube.high)[axis] = middle;
  }
  return cube;
}

/// Cuts cells in the order in which they come up, level by level, so that where memory ends the
/// cuts it ends them at about the same size everywhere.
class Octree::Builder {
 public:
  Builder(std::span<const Bounds3> boxes, const CancelToken* cancel, Octree* tree)
      : boxes_(boxes),
        cancel_(cancel),
        most_listed_(std::min(kMostListed * boxes.size(), kMostPlaces)),
        tree_(*tree) {}

  void Build() {
    Cell root{tree_.cube_, 0, {}};
    for (uint32_t i = 0; i < boxes_.size(); ++i) root.listed.push_back(i);
    listed_ = root.listed.size();
    cells_.push_back(std::move(root));
    for (size_t i = 0; i < cells_.size(); ++i) {
      StopWhenCancelled(cancel_);
      tree_.nodes_.push_back(Cut(i) ? Node{FirstChild(), kInner} : List(&cells_[i].listed));
    }
  }

 private:
  struct Cell {
    Cube cube;
    int depth;
    std::vector<uint32_t> listed;
  };

  /// Appends the eight parts of a cell, unless it is better left whole.
  bool Cut(size_t index) {
    Cell& cell = cells_[index];
    const size_t before = cell.listed.size();
    if (before <= kFewEntries || cell.depth == kMostDepth) return false;
    std::vector<Cell> parts(8);
    size_t after = 0;
    for (uint32_t part = 0; part < 8; ++part) {
      parts[part] = {cell.cube.Part(part), cell.depth + 1, {}};
      for (const uint32_t entry : cell.listed) {
        if (!Reaches(boxes_[entry], parts[part].cube)) continue;
        parts[part].listed.push_back(entry);
        if (++after > kMostGrowth * before) return false;
      }
    }
    if (listed_ + after - before > most_listed_) return false;
    listed_ += after - before;
    tree_.depth_ = std::max(tree_.depth_, cell.depth + 1);
    cell.listed = {};
    std::move(parts.begin(), parts.end(), std::back_inserter(cells_));
    return true;
  }

  /// Of the parts that were appended last.
  uint32_t FirstChild() const { return static_cast<uint32_t>(cells_.size() - 8); }

  Node List(std::vector<uint32_t>* entries) {
    const Node leaf{static_cast<uint32_t>(tree_.listed_.size()),
                    static_cast<uint32_t>(entries->size())};
    tree_.listed_.insert(tree_.listed_.end(), entries->begin(), entries->end());
    *entries = {};
    return leaf;
  }

  const std::span<const Bounds3> boxes_;
  const CancelToken* const cancel_;
  const uint64_t most_listed_;
  Octree& tree_;
  std::vector<Cell> cells_;
  uint64_t listed_ = 0;  ///< By all cells that are not cut.
};

Octree::Octree(EntryTable table, std::span<const Bounds3> boxes, const CancelToken* cancel)
    : Accelerator(std::move(table)) {
  if (boxes.empty()) return;
  Bounds3 bounds;
  for (const Bounds3& box : boxes) bounds.Extend(box);
  cube_.low = ToDouble(bounds.min);
  const Vec3d high = ToDouble(bounds.max), extent = high - cube_.low;
  const double side = std::max({extent.x, extent.y, extent.z});
  cube_.high = Max(cube_.low + Vec3d{side, side, side}, high);  // The sum is rounded.
  Builder(boxes, cancel, this).Build();
}

/// One ray on its way down.
class Octree::Walker {
 public:
  Walker(const Octree& tree, EntrySearch* search)
      : tree_(tree), search_(*search), ray_(search->CurrentRay()) {
    for (int axis = 0; axis < 3; ++axis) {
      if (ray_.direction[axis] < 0) nearest_part_ |= 1u << axis;
    }
  }

  /// True when the search is over.
  bool Visit(const Node& node, const Cube& cube) {
    // The ray is as thick as its rounding.
    const Vec3d around = Vec3d{1, 1, 1} * ray_.rounding;
    const double enter = ray_.Enter(cube.low - around, cube.high + around);
    if (enter > search_.NearestT()) return false;
    if (node.count != kInner) return TestLeaf(node);
    // Counting up, each part comes after all those that the ray can have met before it.
    for (uint32_t i = 0; i < 8; ++i) {
      const uint32_t part = i ^ nearest_part_;
      if (Visit(tree_.nodes_[node.first + part], cube.Part(part))) return true;
    }
    return false;
  }

 private:
  bool TestLeaf(const Node& leaf) {
    for (uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const uint32_t entry = tree_.listed_[i];
      if (tested_.IsNew(entry) && search_.Test(tree_.table().entries[entry])) return true;
    }
    return false;
  }

  const Octree& tree_;
  EntrySearch& search_;
  const PreciseRay ray_;
  uint32_t nearest_part_ = 0;
  Mailbox tested_;
};

bool Octree::Walk(EntrySearch* search) const {
  if (nodes_.empty()) return false;
  return Walker(*this, search).Visit(nodes_[0], cube_);
}

uint64_t Octree::MemoryBytes() const {
  return Accelerator::MemoryBytes() + nodes_.capacity() * sizeof(Node) +
         listed_.capacity() * sizeof(uint32_t);
}

}  // namespace candela::kernel
