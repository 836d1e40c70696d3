#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "base/cancel_token.h"
#include "base/page_memory.h"
#include "kernel/build/box4.h"
#include "kernel/build/build_items.h"

namespace candela::kernel {

/// What the tree is made of: a primitive of an item, or a piece of it, and the box around that.
struct alignas(32) Fragment {
  Float4 low;   ///< Fourth lane: the item.
  Float4 high;  ///< Fourth lane: the primitive in the item.

  Fragment() = default;
  Fragment(const Box4& box, uint32_t item, uint32_t primitive)
      : low(WithFourthBits(box.low, item)), high(WithFourthBits(box.high, primitive)) {}

  uint32_t Item() const { return FourthBits(low); }
  uint32_t Primitive() const { return FourthBits(high); }
  Box4 Box() const { return {low, high}; }
  /// Half the middle, so that no sum or difference of two of them overflows; 0 in the fourth lane.
  Float4 Center() const { return Xyz(low) * Broadcast(0.25f) + Xyz(high) * Broadcast(0.25f); }
  float Center(int axis) const {
    float bounds[8];
    std::memcpy(bounds, this, sizeof(bounds));
    return bounds[axis] * 0.25f + bounds[axis + 4] * 0.25f;
  }

  /// By item and primitive; pieces of a primitive by their boxes. Fragments that are neither less
  /// nor greater are the same.
  friend bool operator<(const Fragment& a, const Fragment& b) {
    if (a.Item() != b.Item()) return a.Item() < b.Item();
    if (a.Primitive() != b.Primitive()) return a.Primitive() < b.Primitive();
    for (int axis = 0; axis < 3; ++axis) {
      if (a.low[axis] != b.low[axis]) return a.low[axis] < b.low[axis];
      if (a.high[axis] != b.high[axis]) return a.high[axis] < b.high[axis];
    }
    return false;
  }
};
static_assert(sizeof(Fragment) == 32);

/// An array of zero bytes, on large pages.
template <class T>
class PageArray {
 public:
  PageArray() = default;
  explicit PageArray(size_t count) : memory_(count * sizeof(T)) {}
  T* data() { return static_cast<T*>(memory_.data()); }
  const T* data() const { return static_cast<const T*>(memory_.data()); }
  T& operator[](size_t i) { return data()[i]; }
  const T& operator[](size_t i) const { return data()[i]; }

 private:
  PageMemory memory_;
};

/// Thrown between the steps of a build when it is cancelled; `BuildGroup` catches it.
struct BuildStopped {};

inline void StopWhenCancelled(const CancelToken* cancel) {
  if (cancel && cancel->IsCancelled()) throw BuildStopped();
}

/// All fragments of the items that rest, or of those that move.
struct FragmentList {
  PageArray<Fragment> fragments;
  uint32_t count = 0;
  uint32_t capacity = 0;  ///< What there is room for.
  Box4 box;               ///< Around all of them.
  Box4 centers;           ///< Around their `Center()`.
  Bounds3 bounds;         ///< Around all of them at all times.
  /// What has no box, in the order of the input.
  struct Unbounded {
    uint32_t item, primitive;
  };
  std::vector<Unbounded> unbounded;
};

/// Makes the fragments of the items in parallel. Leaves room for `growth` times as many.
FragmentList CollectFragments(const std::vector<BuildItem>& items, bool moving, double growth,
                              const CancelToken* cancel);

}  // namespace candela::kernel
