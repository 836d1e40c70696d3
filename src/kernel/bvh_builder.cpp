#include "kernel/bvh_builder.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace candela {
namespace {

constexpr int kBins = 16;
constexpr uint32_t kMostPerLeaf = 4;
constexpr double kStepCost = 1;  // Of visiting a node, in tests of an item.
// From this depth on ranges are halved, which adds at most 32 levels more.
constexpr int kHalvingDepth = Bvh::kMostDepth - 32;

int BinOf(float center, float low, float scale) {
  const int bin = static_cast<int>((center - low) * scale);
  return std::clamp(bin, 0, kBins - 1);
}

/// Bins per unit along an axis; 0 when all centres coincide, or are too close or too far to divide.
float BinScale(const Bounds3& centers, int axis) {
  const float scale = kBins / (centers.max[axis] - centers.min[axis]);
  return std::isfinite(scale) ? scale : 0.0f;
}

}  // namespace

Bvh::Bvh(std::span<const Bounds3> boxes) {
  BvhBuilder(boxes, this).Build();
}

uint64_t Bvh::MemoryBytes() const {
  return nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(uint32_t);
}

int Bvh::Depth() const {
  std::vector<int> depths(nodes_.size(), 1);
  int deepest = 0;
  for (size_t i = 0; i < nodes_.size(); ++i) {  // Children stand after their parent.
    deepest = std::max(deepest, depths[i]);
    if (nodes_[i].count != 0) continue;
    depths[nodes_[i].first] = depths[nodes_[i].first + 1] = depths[i] + 1;
  }
  return deepest;
}

BvhBuilder::BvhBuilder(std::span<const Bounds3> boxes, Bvh* bvh) : bvh_(*bvh) {
  CHECK(boxes.size() < 0x7FFFFFFF);
  references_.reserve(boxes.size());
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].IsEmpty()) references_.push_back({boxes[i], boxes[i].Center(), i});
  }
}

void BvhBuilder::Build() {
  if (references_.empty()) return;
  bvh_.nodes_.reserve(references_.size());
  bvh_.nodes_.emplace_back();
  std::vector<Range> todo = {{0, 0, static_cast<uint32_t>(references_.size()), 0}};
  while (!todo.empty()) {
    const Range range = todo.back();
    todo.pop_back();
    Place(range, &todo);
  }
  bvh_.items_.reserve(references_.size());
  for (const Reference& reference : references_) bvh_.items_.push_back(reference.item);
  bvh_.nodes_.shrink_to_fit();
}

void BvhBuilder::Place(const Range& range, std::vector<Range>* todo) {
  Bounds3 bounds, centers;
  for (uint32_t i = range.begin; i < range.end; ++i) {
    bounds.Extend(references_[i].bounds);
    centers.Extend(references_[i].center);
  }
  bvh_.nodes_[range.node].bounds = bounds;

  const uint32_t count = range.end - range.begin;
  const uint32_t middle = count == 1 ? range.begin : Partition(range, bounds, centers);
  if (middle == range.begin) {
    bvh_.nodes_[range.node].first = range.begin;
    bvh_.nodes_[range.node].count = count;
    return;
  }
  const auto left = static_cast<uint32_t>(bvh_.nodes_.size());
  bvh_.nodes_.resize(left + 2);
  bvh_.nodes_[range.node].first = left;
  // The left one is taken next, so that its descendants follow closely.
  todo->push_back({left + 1, middle, range.end, range.depth + 1});
  todo->push_back({left, range.begin, middle, range.depth + 1});
}

/// Splits the range in two and returns the border, or its begin when a leaf is better.
uint32_t BvhBuilder::Partition(const Range& range, const Bounds3& bounds, const Bounds3& centers) {
  const uint32_t count = range.end - range.begin;
  const auto begin = references_.begin() + range.begin;
  const auto end = references_.begin() + range.end;
  if (range.depth < kHalvingDepth) {
    const Split split = FindSplit({&*begin, count}, centers);
    const double area = bounds.HalfArea();
    const bool is_worth = kStepCost * area + split.cost < area * count;
    if (!is_worth && count <= kMostPerLeaf) return range.begin;
    if (split.cost < Bounds3::kInfinity) {
      const float scale = BinScale(centers, split.axis);
      const float low = centers.min[split.axis];
      const auto border = std::partition(begin, end, [&](const Reference& reference) {
        return BinOf(reference.center[split.axis], low, scale) < split.bin;
      });
      return static_cast<uint32_t>(border - references_.begin());
    }
  }
  if (count <= kMostPerLeaf) return range.begin;
  // Coinciding centres, or a tree that grows too deep: halve by position, then by index.
  const int axis = LargestAxis(centers.Extent());
  const auto middle = begin + count / 2;
  std::nth_element(begin, middle, end, [axis](const Reference& a, const Reference& b) {
    return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis] : a.item < b.item;
  });
  return range.begin + count / 2;
}

BvhBuilder::Split BvhBuilder::FindSplit(std::span<const Reference> references,
                                        const Bounds3& centers) const {
  struct Bin {
    Bounds3 bounds;
    uint32_t count = 0;
    double Cost() const { return bounds.HalfArea() * count; }
    void Extend(const Bin& other) {
      bounds.Extend(other.bounds);
      count += other.count;
    }
  };
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const float scale = BinScale(centers, axis);
    if (scale == 0) continue;
    std::array<Bin, kBins> bins;
    for (const Reference& reference : references) {
      Bin& bin = bins[static_cast<size_t>(BinOf(reference.center[axis], centers.min[axis], scale))];
      bin.bounds.Extend(reference.bounds);
      ++bin.count;
    }
    // One sweep from the right keeps the cost of each right side, one from the left adds its own.
    std::array<double, kBins> right_cost;
    Bin right;
    for (int i = kBins - 1; i > 0; --i) {
      right.Extend(bins[static_cast<size_t>(i)]);
      right_cost[static_cast<size_t>(i)] = right.count == 0 ? Bounds3::kInfinity : right.Cost();
    }
    Bin left;
    for (int i = 1; i < kBins; ++i) {
      left.Extend(bins[static_cast<size_t>(i - 1)]);
      const double cost =
          left.count == 0 ? Bounds3::kInfinity : left.Cost() + right_cost[static_cast<size_t>(i)];
      if (cost < best.cost) best = {axis, i, cost};
    }
  }
  return best;
}

}  // namespace candela
