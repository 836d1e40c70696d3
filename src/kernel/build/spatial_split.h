#pragma once

#include <cstdint>
#include <vector>

#include "kernel/build/build_items.h"
#include "kernel/build/fragment.h"

/// Splits that divide space instead of the fragments: triangles on both sides are cut. Martin
/// Stich, Heiko Friedrich, Andreas Dietrich: Spatial Splits in Bounding Volume Hierarchies, 2009.
namespace candela::kernel {

constexpr int kSpatialBins = 16;

/// Slabs of equal width between the sides of a box, on each axis.
struct SlabMapping {
  explicit SlabMapping(const Box4& box);

  bool IsUseful(int axis) const { return slabs_per_unit[axis] > 0; }
  /// The slab of a coordinate; -1 below the first one.
  int SlabOf(int axis, float x) const {
    const float slab = (x - origin[axis]) * slabs_per_unit[axis];
    return slab < 0 ? -1 : slab < kSpatialBins ? static_cast<int>(slab) : kSpatialBins;
  }
  /// The border between a slab and the one before it.
  float Border(int axis, int slab) const {
    return origin[axis] + static_cast<float>(slab) * width[axis];
  }

  Float4 origin, slabs_per_unit, width;
};

/// The parts of a fragment in each slab of an axis.
class Pieces {
 public:
  Pieces(const std::vector<BuildItem>& items, const SlabMapping& mapping)
      : items_(items), mapping_(mapping) {}

  /// Has to be called first. Only triangles are cut; anything else is in the slab of its centre.
  void Cut(const Fragment& fragment, int axis);

  int first() const { return first_; }  ///< The first and the last slab with a part in it.
  int last() const { return last_; }
  const Box4& operator[](int slab) const { return piece_[slab]; }

 private:
  void CutTriangle(const Fragment& fragment, int axis);

  const std::vector<BuildItem>& items_;
  const SlabMapping& mapping_;
  int first_ = 0, last_ = 0;
  Box4 piece_[kSpatialBins];
};

/// A border between two slabs: what is below it goes to the left, at or above it to the right.
struct SpatialSplit {
  float cost = Bounds3::kInfinity;  ///< As in `ObjectSplit`.
  int axis = 0;
  int slab = 0;
  uint32_t left_count = 0, right_count = 0;
  Box4 left, right;
};

/// Boxes of the pieces in each slab of each axis, and how many fragments begin and end there.
class SpatialBins {
 public:
  void Add(const Fragment* begin, const Fragment* end, const SlabMapping& mapping,
           const std::vector<BuildItem>& items);
  void Merge(const SpatialBins& other);
  SpatialSplit FindSplit(float area_scale) const;

 private:
  Box4 box_[3][kSpatialBins];
  uint32_t begin_[3][kSpatialBins] = {}, end_[3][kSpatialBins] = {};
};

}  // namespace candela::kernel
