#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>

/// Lanes without instructions of their own: what every other file of this folder has to equal, bit
/// for bit. Read this one first.
namespace candela::kernel::scalar {

/// Numbers that are computed with side by side.
template <class T, int N>
struct Lanes {
  static constexpr int kCount = N;
  T lane[N];

  template <class Function>
  [[gnu::always_inline]] static Lanes Each(Function function) {
    Lanes result;
    for (int i = 0; i < N; ++i) result.lane[i] = function(i);
    return result;
  }
  /// The answers to a comparison; bit i belongs to lane i.
  struct Mask {
    uint32_t bits;
    uint32_t Bits() const { return bits; }
    friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  };
  template <class Predicate>
  [[gnu::always_inline]] static Mask Where(Predicate predicate) {
    Mask mask{0};
    for (int i = 0; i < N; ++i) mask.bits |= static_cast<uint32_t>(predicate(i)) << i;
    return mask;
  }

  static Lanes Load(const T* from) {
    return Each([=](int i) { return from[i]; });
  }
  static Lanes Broadcast(T value) {
    return Each([=](int) { return value; });
  }
  void Store(T* to) const {
    for (int i = 0; i < N; ++i) to[i] = lane[i];
  }

  friend Lanes operator+(Lanes a, Lanes b) {
    return Each([&](int i) { return a.lane[i] + b.lane[i]; });
  }
  friend Lanes operator-(Lanes a, Lanes b) {
    return Each([&](int i) { return a.lane[i] - b.lane[i]; });
  }
  friend Lanes operator*(Lanes a, Lanes b) {
    return Each([&](int i) { return a.lane[i] * b.lane[i]; });
  }
  friend Lanes operator/(Lanes a, Lanes b) {
    return Each([&](int i) { return a.lane[i] / b.lane[i]; });
  }
  /// a * b - c with one rounding.
  friend Lanes FusedSubtract(Lanes a, Lanes b, Lanes c) {
    return Each([&](int i) { return std::fma(a.lane[i], b.lane[i], -c.lane[i]); });
  }
  /// The second one when they are equal or one is not a number, as the instructions have it.
  friend Lanes Min(Lanes a, Lanes b) {
    return Each([&](int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
  }
  friend Lanes Max(Lanes a, Lanes b) {
    return Each([&](int i) { return a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]; });
  }
  /// Never true for what is not a number.
  friend Mask operator<(Lanes a, Lanes b) {
    return Where([&](int i) { return a.lane[i] < b.lane[i]; });
  }
  friend Mask operator<=(Lanes a, Lanes b) {
    return Where([&](int i) { return a.lane[i] <= b.lane[i]; });
  }
};

/// Lane numbers 0 to 7, one in the lower three bits of each lane.
struct Index8 {
  uint32_t lane[8];

  /// Lane i gets bits 3i to 3i + 2.
  static Index8 Unpack(uint32_t packed) {
    Index8 index;
    for (int i = 0; i < 8; ++i) index.lane[i] = packed >> 3 * i & 7;
    return index;
  }
};

using Float8 = Lanes<float, 8>;

/// Lane i of the result is the lane of `from` with number i of `index`.
inline Float8 Permute(Float8 from, Index8 index) {
  return Float8::Each([&](int i) { return from.lane[index.lane[i]]; });
}

/// The lanes of `mask` first, in the order of their distances from far to near, all others behind;
/// distances that differ in their last three bits only are in the order of the lanes, backwards.
inline Index8 OrderFarToNear(Float8 distance, Float8::Mask mask) {
  int64_t key[8];
  for (uint32_t i = 0; i < 8; ++i) {
    const uint32_t distance_bits = std::bit_cast<uint32_t>(distance.lane[i]);
    key[i] = mask.bits >> i & 1 ? int64_t{(distance_bits & ~7u) | i} : -1 - int64_t{i};
  }
  std::sort(key, key + 8, std::greater<>());
  Index8 index;
  for (int i = 0; i < 8; ++i) index.lane[i] = static_cast<uint32_t>(key[i]) & 7;
  return index;
}

/// Writes pairs of lanes, the one of `low` first.
inline void StorePairs(Float8 low, Float8 high, uint64_t* to) {
  for (int i = 0; i < 8; ++i) {
    to[i] = uint64_t{std::bit_cast<uint32_t>(high.lane[i])} << 32 |
            std::bit_cast<uint32_t>(low.lane[i]);
  }
}

/// What the traversal is compiled with.
struct IsaLanes {
  static constexpr int kWidth = 8;       ///< Children of a node.
  static constexpr bool kMoves = false;  ///< See `MovingLanes`.
  using Node = Float8;
  using Leaf = Float8;
  using Index = Index8;
  using Packet = Lanes<float, 16>;
};

}  // namespace candela::kernel::scalar
