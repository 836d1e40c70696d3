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

  /// The slabs of a point, on all axes, moved into a range: for a point of the box the slabs that
  /// there are, for any other one with -1 below them and kSpatialBins above.
  Int4 SlabsOf(Float4 point, int lowest, int highest) const {
    const Float4 slabs = (Xyz(point) - origin) * slabs_per_unit + Broadcast(1);
    const auto least = static_cast<float>(lowest + 1), most = static_cast<float>(highest + 1);
    return __builtin_convertvector(Min(Max(slabs, Broadcast(least)), Broadcast(most)), Int4) - 1;
  }
  /// The border between a slab and the one before it.
  float Border(int axis, int slab) const {
    return origin[axis] + static_cast<float>(slab) * width[axis];
  }

  Float4 origin, slabs_per_unit, width;
};

/// Cuts a fragment along the slabs of an axis.
class Pieces {
 public:
  Pieces(const std::vector<BuildItem>& items, const SlabMapping& mapping)
      : items_(items), mapping_(mapping) {}

  /// Has to be called first: the fragment to cut.
  void Take(const Fragment& fragment) {
    box_ = fragment.Box();
    first_slab_ = mapping_.SlabsOf(box_.low, 0, kSpatialBins - 1);
    last_slab_ = mapping_.SlabsOf(box_.high, 0, kSpatialBins - 1);
    is_loaded_ = false;
  }
  /// Finds its parts. Only triangles are cut; anything else is in the slab of its middle.
  void Cut(int axis);

  int first() const { return first_; }  ///< The first and the last slab with a part in it.
  int last() const { return last_; }
  const Box4& operator[](int slab) const { return piece_[slab]; }

 private:
  void CutTriangle(int axis);
  Box4 Crossing(int axis, int slab) const;
  bool LoadTriangle();

  const std::vector<BuildItem>& items_;
  const SlabMapping& mapping_;
  Box4 box_;  ///< Of the fragment, with the item and the primitive.
  Int4 first_slab_, last_slab_;
  bool is_loaded_ = false;
  Float4 corner_[3];
  Int4 corner_slab_[3];
  float padding_ = 0;
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
  uint32_t whole_[3][kSpatialBins] = {};                              ///< That begin and end there.
  uint32_t begin_[3][kSpatialBins] = {}, end_[3][kSpatialBins] = {};  ///< The others.
};

}  // namespace candela::kernel
