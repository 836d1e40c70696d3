#include "kernel/build/binning.h"

#include <algorithm>
#include <cmath>

namespace candela::kernel {

BinMapping::BinMapping(const Box4& centers, uint32_t fragments)
    : origin(Xyz(centers.low)),
      scale(Splat(0)),
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
  for (int axis = 0; axis < 3; ++axis) {
    std::fill_n(box_[axis], bins_, Box4{});
    std::fill_n(count_[axis], bins_, 0u);
  }
}

void Bins::Add(const Fragment* begin, const Fragment* end, const BinMapping& mapping) {
  for (const Fragment* fragment = begin; fragment != end; ++fragment) {
    const Box4 box = fragment->Box();
    const Int4 bin = __builtin_convertvector(mapping.Position(fragment->Center()), Int4);
    for (int axis = 0; axis < 3; ++axis) {
      box_[axis][bin[axis]].Extend(box);
      ++count_[axis][bin[axis]];
    }
  }
}

void Bins::Merge(const Bins& other) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < bins_; ++i) {
      box_[axis][i].Extend(other.box_[axis][i]);
      count_[axis][i] += other.count_[axis][i];
    }
  }
}

ObjectSplit Bins::FindSplit(float area_scale) const {
  ObjectSplit best;
  for (int axis = 0; axis < 3; ++axis) {
    // One sweep from the right keeps the cost of each right side, one from the left adds its own.
    // The area of nothing times 0 is a NaN, which is not less than anything.
    float right_cost[kMostBins];
    Box4 box;
    uint32_t count = 0;
    for (int i = bins_ - 1; i > 0; --i) {
      box.Extend(box_[axis][i]);
      count += count_[axis][i];
      right_cost[i] = box.HalfArea(area_scale) * static_cast<float>(count);
    }
    box = Box4{};
    count = 0;
    for (int i = 1; i < bins_; ++i) {
      box.Extend(box_[axis][i - 1]);
      count += count_[axis][i - 1];
      const float cost = box.HalfArea(area_scale) * static_cast<float>(count) + right_cost[i];
      if (cost < best.cost) best = {cost, axis, i, count, box, Box4{}};
    }
  }
  for (int i = best.bin; best.IsFound() && i < bins_; ++i) best.right.Extend(box_[best.axis][i]);
  return best;
}

}  // namespace candela::kernel
