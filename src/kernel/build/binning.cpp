#include "kernel/build/binning.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace candela::kernel {

BinMapping::BinMapping(const Box4& centers, uint32_t fragments)
    : origin(Xyz(centers.low)),
      scale(Broadcast(0)),
      bins(static_cast<int>(std::min<uint32_t>(kMostBins, 8 + fragments / 16))) {
  const Float4 extent = centers.high - centers.low;
  for (int axis = 0; axis < 3; ++axis) {
    // Slightly less than all bins, so that no centre is rounded up to one more.
    const float bins_per_unit = static_cast<float>(bins) * (1 - 4e-7f) / extent[axis];
    if (std::isfinite(bins_per_unit)) scale[axis] = bins_per_unit;
  }
}

void Bins::Clear(int count) {
  bins_ = count;
  for (int axis = 0; axis < 3; ++axis) std::fill_n(box_[axis], bins_, Box4{});
  std::fill_n(&count_[0][0], 4 * bins_, 0);
}

void Bins::Add(const Fragment* begin, const Fragment* end, const BinMapping& mapping) {
  for (const Fragment* fragment = begin; fragment != end; ++fragment) {
    const Box4 box = fragment->Box();
    const Int4 bin = __builtin_convertvector(mapping.Position(fragment->Center()), Int4);
    for (int axis = 0; axis < 3; ++axis) {
      box_[axis][bin[axis]].Extend(box);
      ++count_[bin[axis]][axis];
    }
  }
}

void Bins::Merge(const Bins& other) {
  for (int i = 0; i < bins_; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      box_[axis][i].Extend(other.box_[axis][i]);
      count_[i][axis] += other.count_[i][axis];
    }
  }
}

ObjectSplit Bins::FindSplit(float area_scale) const {
  // All axes at once. One sweep from the right keeps the cost of each right side, one from the left
  // adds its own. The area of nothing times 0 is a NaN, which is not less than anything.
  const Float4 scale = Broadcast(area_scale);
  Float4 right_cost[kMostBins];
  Box4 box[3];
  Int4 count = {0, 0, 0, 0};
  for (int i = bins_ - 1; i > 0; --i) {
    for (int axis = 0; axis < 3; ++axis) box[axis].Extend(box_[axis][i]);
    count += CountsOf(i);
    right_cost[i] =
        HalfAreas(box[0], box[1], box[2], scale) * __builtin_convertvector(count, Float4);
  }
  Float4 best_cost = Broadcast(Bounds3::kInfinity);
  Int4 best_bin = {0, 0, 0, 0};
  for (Box4& each : box) each = Box4{};
  count = Int4{0, 0, 0, 0};
  for (int i = 1; i < bins_; ++i) {
    for (int axis = 0; axis < 3; ++axis) box[axis].Extend(box_[axis][i - 1]);
    count += CountsOf(i - 1);
    const Float4 cost =
        HalfAreas(box[0], box[1], box[2], scale) * __builtin_convertvector(count, Float4) +
        right_cost[i];
    const Int4 is_better = cost < best_cost;
    best_cost = is_better ? cost : best_cost;
    best_bin = is_better ? Int4{i, i, i, i} : best_bin;
  }
  ObjectSplit best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(best_cost[axis] < best.cost)) continue;
    best.cost = best_cost[axis];
    best.axis = axis;
    best.bin = best_bin[axis];
  }
  if (!best.IsFound()) return best;
  for (int i = 0; i < best.bin; ++i) {
    best.left.Extend(box_[best.axis][i]);
    best.left_count += static_cast<uint32_t>(count_[i][best.axis]);
  }
  for (int i = best.bin; i < bins_; ++i) best.right.Extend(box_[best.axis][i]);
  return best;
}

Int4 Bins::CountsOf(int bin) const {
  Int4 counts;
  std::memcpy(&counts, count_[bin], sizeof(counts));
  return counts;
}

}  // namespace candela::kernel
