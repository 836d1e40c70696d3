#include "kernel/build/spatial_split.h"

#include <algorithm>
#include <cmath>

namespace candela::kernel {

SlabMapping::SlabMapping(const Box4& box)
    : origin(Xyz(box.low)), slabs_per_unit(Broadcast(0)), width(Broadcast(0)) {
  const Float4 extent = box.high - box.low;
  for (int axis = 0; axis < 3; ++axis) {
    // Slightly less than all slabs, so that the upper side is in the last one.
    const float slabs = kSpatialBins * (1 - 1e-6f);
    if (!std::isfinite(extent[axis]) || !std::isfinite(slabs / extent[axis])) continue;
    slabs_per_unit[axis] = slabs / extent[axis];
    width[axis] = extent[axis] / slabs;
  }
}

void Pieces::Cut(int axis) {
  first_ = first_slab_[axis];
  last_ = last_slab_[axis];
  if (first_ != last_) {
    if (LoadTriangle()) {
      CutTriangle(axis);
    } else {
      first_ = last_ = (first_ + last_) / 2;
    }
  }
  if (first_ == last_) piece_[first_] = box_;
}

/// False when it may not be cut, or is too large to calculate with.
bool Pieces::LoadTriangle() {
  if (is_loaded_) return std::isfinite(padding_);
  is_loaded_ = true;
  padding_ = Bounds3::kInfinity;
  const BuildItem& item = items_[FourthBits(box_.low)];
  if (!item.may_split) return false;
  const auto& vertices = item.triangles->triangles[FourthBits(box_.high)];
  for (size_t i = 0; i < 3; ++i) {
    corner_[i] = ToFloat4(item.Position(0, vertices[i]));
    corner_slab_[i] = mapping_.SlabsOf(corner_[i], -1, kSpatialBins);
  }
  // As the whole triangle is padded, and for the rounding of the points on edges.
  const Float4 low = Min(Min(corner_[0], corner_[1]), corner_[2]);
  const Float4 high = Max(Max(corner_[0], corner_[1]), corner_[2]);
  padding_ = (kTrianglePadding + 4e-7f) * LargestOf3(high - low);
  return std::isfinite(padding_);
}

/// The box of the points where edges cross the lower border of a slab; empty when none does.
/// Without branches, which would depend on how each triangle happens to lie.
Box4 Pieces::Crossing(int axis, int slab) const {
  const float border = mapping_.Border(axis, slab);
  Box4 box;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const bool crosses = (corner_slab_[i][axis] < slab) != (corner_slab_[j][axis] < slab);
    const float start = corner_[i][axis];
    const float part = (border - start) / (corner_[j][axis] - start);
    const Float4 t = Min(Max(Broadcast(part), Broadcast(0)), Broadcast(1));
    box.ExtendIf(crosses, corner_[i] + (corner_[j] - corner_[i]) * t);
  }
  return box;
}

void Pieces::CutTriangle(int axis) {
  int first = last_ + 1, last = first_ - 1;
  Box4 below = Crossing(axis, first_);
  for (int slab = first_; slab <= last_; ++slab) {
    // The corners in the slab, and what the edges have on both of its borders.
    const Box4 above = Crossing(axis, slab + 1);
    Box4 piece = below;
    piece.Extend(above);
    for (int i = 0; i < 3; ++i) piece.ExtendIf(corner_slab_[i][axis] == slab, corner_[i]);
    below = above;
    piece_[slab] = Box4{};
    if (piece.IsEmpty()) continue;
    // A fragment may be smaller than its triangle.
    piece = Padded(piece, padding_);
    piece = {Max(piece.low, box_.low), Min(piece.high, box_.high)};
    if (piece.IsEmpty()) continue;
    piece_[slab] = piece;
    first = std::min(first, slab);
    last = slab;
  }
  if (first > last) first = last = first_;
  first_ = first;
  last_ = last;
}

void SpatialBins::Add(const Fragment* begin, const Fragment* end, const SlabMapping& mapping,
                      const std::vector<BuildItem>& items) {
  Pieces pieces(items, mapping);
  for (const Fragment* fragment = begin; fragment != end; ++fragment) {
    const Box4 box = fragment->Box();
    const Int4 first = mapping.SlabsOf(box.low, 0, kSpatialBins - 1);
    const Int4 last = mapping.SlabsOf(box.high, 0, kSpatialBins - 1);
    const Int4 differs = first ^ last;
    if ((differs[0] | differs[1] | differs[2]) == 0) {  // Most are small: nothing to cut.
      for (int axis = 0; axis < 3; ++axis) {
        box_[axis][first[axis]].Extend(box);
        ++whole_[axis][first[axis]];
      }
      continue;
    }
    pieces.Take(*fragment);
    for (int axis = 0; axis < 3; ++axis) {
      if (differs[axis] == 0) {
        box_[axis][first[axis]].Extend(box);
        ++whole_[axis][first[axis]];
        continue;
      }
      pieces.Cut(axis);
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
      whole_[axis][i] += other.whole_[axis][i];
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
      count += whole_[axis][i] + end_[axis][i];
      right_box[i] = box;
      right_count[i] = count;
    }
    box = Box4{};
    count = 0;
    for (int i = 1; i < kSpatialBins; ++i) {
      box.Extend(box_[axis][i - 1]);
      count += whole_[axis][i - 1] + begin_[axis][i - 1];
      if (count == 0 || right_count[i] == 0) continue;
      const float cost = box.HalfArea(area_scale) * static_cast<float>(count) +
                         right_box[i].HalfArea(area_scale) * static_cast<float>(right_count[i]);
      if (cost < best.cost) best = {cost, axis, i, count, right_count[i], box, right_box[i]};
    }
  }
  return best;
}

}  // namespace candela::kernel
