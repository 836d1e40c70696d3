#pragma once

#include "geometry/bounds3.h"
#include "kernel/build/float4.h"

namespace candela::kernel {

/// A `Bounds3` in two registers. The fourth lanes mean nothing.
struct Box4 {
  Float4 low = Splat(Bounds3::kInfinity);
  Float4 high = Splat(-Bounds3::kInfinity);

  static Box4 Of(const Bounds3& bounds) { return {Load(bounds.min), Load(bounds.max)}; }
  Bounds3 ToBounds() const { return {ToVec3(low), ToVec3(high)}; }

  void Extend(Float4 point) {
    low = Min(low, point);
    high = Max(high, point);
  }
  void Extend(const Box4& other) {
    low = Min(low, other.low);
    high = Max(high, other.high);
  }
  bool IsEmpty() const { return !(low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2]); }

  /// Half of the surface area times the square of `scale`. With `AreaScale` of a box around this
  /// one, the result neither overflows nor vanishes before it is negligible beside that box.
  float HalfArea(float scale) const {
    const Float4 extent = (high - low) * Splat(scale);
    const Float4 next = __builtin_shufflevector(extent, extent, 1, 2, 0, 3);
    const Float4 product = extent * next;
    return product[0] + product[1] + product[2];
  }
};

/// A power of two that takes the largest extent of a box to about 1.
inline float AreaScale(const Box4& box) {
  const Float4 half = box.high * Splat(0.5f) - box.low * Splat(0.5f);  // The whole may overflow.
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
    return {at[0].low * Splat(0.5f) + at[1].low * Splat(0.5f),
            at[0].high * Splat(0.5f) + at[1].high * Splat(0.5f)};
  }
};

}  // namespace candela::kernel
