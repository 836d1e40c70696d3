#include "kernel/build/spatial_split.h"

#include <algorithm>
#include <cmath>

namespace candela::kernel {

SlabMapping::SlabMapping(const Box4& box)
    : origin(Xyz(box.low)), slabs_per_unit(Splat(0)), width(Splat(0)) {
  const Float4 extent = box.high - box.low;
  for (int axis = 0; axis < 3; ++axis) {
    // Slightly less than all slabs, so that the upper side is in the last one.
    const float slabs = kSpatialBins * (1 - 1e-6f);
    if (!std::isfinite(extent[axis]) || !std::isfinite(slabs / extent[axis])) continue;
    slabs_per_unit[axis] = slabs / extent[axis];
    width[axis] = extent[axis] / slabs;
  }
}

void Pieces::Cut(const Fragment& fragment, int axis) {
  first_ = std::clamp(mapping_.SlabOf(axis, fragment.low[axis]), 0, kSpatialBins - 1);
  last_ = std::clamp(mapping_.SlabOf(axis, fragment.high[axis]), 0, kSpatialBins - 1);
  if (first_ != last_ && items_[fragment.Item()].triangles) {
    CutTriangle(fragment, axis);
  } else {
    first_ = last_ = (first_ + last_) / 2;
  }
  if (first_ == last_) piece_[first_] = fragment.Box();
}

void Pieces::CutTriangle(const Fragment& fragment, int axis) {
  const BuildItem& item = items_[fragment.Item()];
  const auto& vertices = item.triangles->triangles[fragment.Primitive()];
  const Float4 corner[3] = {Load(item.Position(0, vertices[0])),
                            Load(item.Position(0, vertices[1])),
                            Load(item.Position(0, vertices[2]))};
  std::fill(piece_ + first_, piece_ + last_ + 1, Box4{});
  // A corner belongs to the piece in its slab; where an edge crosses a border, the point belongs to
  // the pieces on both sides.
  for (int i = 0; i < 3; ++i) {
    Float4 a = corner[i], b = corner[(i + 1) % 3];
    int slab_a = mapping_.SlabOf(axis, a[axis]), slab_b = mapping_.SlabOf(axis, b[axis]);
    if (slab_a >= first_ && slab_a <= last_) piece_[slab_a].Extend(a);
    if (slab_a > slab_b) {
      std::swap(a, b);
      std::swap(slab_a, slab_b);
    }
    for (int slab = std::max(slab_a + 1, first_); slab <= std::min(slab_b, last_ + 1); ++slab) {
      const float border = mapping_.Border(axis, slab);
      const float t = std::clamp((border - a[axis]) / (b[axis] - a[axis]), 0.0f, 1.0f);
      const Float4 point = a + (b - a) * Splat(t);
      if (slab > first_) piece_[slab - 1].Extend(point);
      if (slab <= last_) piece_[slab].Extend(point);
    }
  }
  // As the whole triangle is padded, and for the rounding of the points.
  const Float4 low = Min(Min(corner[0], corner[1]), corner[2]);
  const Float4 high = Max(Max(corner[0], corner[1]), corner[2]);
  const float padding = (kTrianglePadding + 4e-7f) * LargestOf3(high - low);
  int first = last_ + 1, last = first_ - 1;
  for (int slab = first_; slab <= last_; ++slab) {
    if (piece_[slab].IsEmpty()) continue;
    const Box4 padded = Padded(piece_[slab], padding);
    piece_[slab] = {Max(padded.low, fragment.low), Min(padded.high, fragment.high)};
    if (piece_[slab].IsEmpty()) {
      piece_[slab] = Box4{};
      continue;
    }
    first = std::min(first, slab);
    last = slab;
  }
  // A fragment may be smaller than its triangle, and between two of its slabs be outside of it.
  if (first > last) first = last = first_;
  first_ = first;
  last_ = last;
}

void SpatialBins::Add(const Fragment* begin, const Fragment* end, const SlabMapping& mapping,
                      const std::vector<BuildItem>& items) {
  Pieces pieces(items, mapping);
  for (const Fragment* fragment = begin; fragment != end; ++fragment) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!mapping.IsUseful(axis)) continue;
      pieces.Cut(*fragment, axis);
      ++begin_[axis][pieces.first()];
      ++end_[axis][pieces.last()];
      for (int slab = pieces.first(); slab <= pieces.last(); ++slab) {
        box_[axis][slab].Extend(pieces[slab]);
      }
    }
  }
}

void SpatialBins::Merge(const SpatialBins& other) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < kSpatialBins; ++i) {
      box_[axis][i].Extend(other.box_[axis][i]);
      begin_[axis][i] += other.begin_[axis][i];
      end_[axis][i] += other.end_[axis][i];
    }
  }
}

SpatialSplit SpatialBins::FindSplit(float area_scale) const {
  SpatialSplit best;
  for (int axis = 0; axis < 3; ++axis) {
    Box4 right_box[kSpatialBins];
    uint32_t right_count[kSpatialBins];
    Box4 box;
    uint32_t count = 0;
    for (int i = kSpatialBins - 1; i > 0; --i) {
      box.Extend(box_[axis][i]);
      count += end_[axis][i];
      right_box[i] = box;
      right_count[i] = count;
    }
    box = Box4{};
    count = 0;
    for (int i = 1; i < kSpatialBins; ++i) {
      box.Extend(box_[axis][i - 1]);
      count += begin_[axis][i - 1];
      if (count == 0 || right_count[i] == 0) continue;
      const float cost = box.HalfArea(area_scale) * static_cast<float>(count) +
                         right_box[i].HalfArea(area_scale) * static_cast<float>(right_count[i]);
      if (cost < best.cost) best = {cost, axis, i, count, right_count[i], box, right_box[i]};
    }
  }
  return best;
}

}  // namespace candela::kernel
