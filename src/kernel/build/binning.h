#pragma once

#include <cstdint>

#include "kernel/build/fragment.h"

/// The binned surface area heuristic. Ingo Wald: On fast Construction of SAH-based Bounding Volume
/// Hierarchies, 2007.
namespace candela::kernel {

constexpr int kMostBins = 32;

/// Which bin a centre belongs to, on all axes at once.
struct BinMapping {
  BinMapping(const Box4& centers, uint32_t fragments);

  /// In bins; not below 0, below `bins`. An axis without extent has only bin 0.
  Float4 Position(Float4 center) const { return (center - origin) * scale; }
  /// `Position(fragment.Center())[axis] < bin`.
  bool IsBelow(const Fragment& fragment, int axis, float bin) const {
    return (fragment.Center(axis) - origin[axis]) * scale[axis] < bin;
  }
  bool IsUseful() const { return scale[0] > 0 || scale[1] > 0 || scale[2] > 0; }

  Float4 origin, scale;
  int bins;
};

/// A border between two bins: what is below it goes to the left.
struct ObjectSplit {
  float cost = Bounds3::kInfinity;  ///< The sum of half area times fragments of both sides.
  int axis = 0;
  int bin = 0;
  uint32_t left_count = 0;
  Box4 left, right;

  bool IsFound() const { return cost < Bounds3::kInfinity; }
};

/// Boxes of the fragments in each bin of each axis.
class Bins {
 public:
  /// Has to be called first.
  void Clear(int count);
  void Add(const Fragment* begin, const Fragment* end, const BinMapping& mapping);
  void Merge(const Bins& other);

  /// The best split; areas are taken times `area_scale` squared.
  ObjectSplit FindSplit(float area_scale) const;

 private:
  Int4 CountsOf(int bin) const;

  Box4 box_[3][kMostBins];
  int32_t count_[kMostBins][4];  ///< By bin and axis: a bin is a register.
  int bins_ = 0;
};

}  // namespace candela::kernel
