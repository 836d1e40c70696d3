#pragma once

#include <bit>
#include <cstdint>

#include "geometry/bounds3.h"
#include "math/float4.h"

namespace candela::kernel {

/// A `Bounds3` in two registers. The fourth lanes mean nothing.
struct Box4 {
  Float4 low = Broadcast(Bounds3::kInfinity);
  Float4 high = Broadcast(-Bounds3::kInfinity);

  static Box4 Of(const Bounds3& bounds) { return {ToFloat4(bounds.min), ToFloat4(bounds.max)}; }
  Bounds3 ToBounds() const { return {ToVec3(low), ToVec3(high)}; }

  void Extend(Float4 point) {
    low = Min(low, point);
    high = Max(high, point);
  }
  void ExtendIf(bool condition, Float4 point) {
    const int32_t all = condition ? -1 : 0;
    const Int4 mask = {all, all, all, all};
    low = Min(low, mask ? point : low);
    high = Max(high, mask ? point : high);
  }
  void Extend(const Box4& other) {
    low = Min(low, other.low);
    high = Max(high, other.high);
  }
  bool IsEmpty() const { return !(low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2]); }

  /// Half of the surface area times the square of `scale`. With `AreaScale` of a box around this
  /// one, the result neither overflows nor vanishes before it is negligible beside that box.
  float HalfArea(float scale) const {
    const Float4 extent = (high - low) * Broadcast(scale);
    const Float4 next = __builtin_shufflevector(extent, extent, 1, 2, 0, 3);
    const Float4 product = extent * next;
    return product[0] + product[1] + product[2];
  }
};

/// `HalfArea` of three boxes, in the first three lanes.
inline Float4 HalfAreas(const Box4& a, const Box4& b, const Box4& c, Float4 scale) {
  const Float4 ea = (a.high - a.low) * scale, eb = (b.high - b.low) * scale;
  const Float4 ec = (c.high - c.low) * scale;
  const Float4 ab_xy = __builtin_shufflevector(ea, eb, 0, 4, 1, 5);
  const Float4 ab_z = __builtin_shufflevector(ea, eb, 2, 6, 3, 7);
  const Float4 x = __builtin_shufflevector(ab_xy, ec, 0, 1, 4, 7);
  const Float4 y = __builtin_shufflevector(ab_xy, ec, 2, 3, 5, 7);
  const Float4 z = __builtin_shufflevector(ab_z, ec, 0, 1, 6, 7);
  return x * y + y * z + z * x;
}

/// A power of two that takes the largest extent of a box to about 1.
inline float AreaScale(const Box4& box) {
  const Float4 half =
      box.high * Broadcast(0.5f) - box.low * Broadcast(0.5f);  // The whole may overflow.
  const float largest = LargestOf3(half);
  if (largest == 0) return 1;
  const int exponent = static_cast<int>(std::bit_cast<uint32_t>(largest) >> 23 & 255);
  // The reciprocal of the power of two below, kept in the range of normal numbers.
  const int inverse = exponent >= 253 ? 1 : exponent <= 1 ? 253 : 254 - exponent;
  return std::bit_cast<float>(static_cast<uint32_t>(inverse) << 23);
}

/// The boxes of something that moves, at time 0 and at time 1.
struct LinearBox {
  Box4 at[2];

  void Extend(const LinearBox& other) {
    at[0].Extend(other.at[0]);
    at[1].Extend(other.at[1]);
  }
  /// The box in the middle of the time: what the moving thing is sorted into the tree by.
  Box4 Middle() const {
    return {at[0].low * Broadcast(0.5f) + at[1].low * Broadcast(0.5f),
            at[0].high * Broadcast(0.5f) + at[1].high * Broadcast(0.5f)};
  }
};

}  // namespace candela::kernel
