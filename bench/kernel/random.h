#pragma once

#include <cstdint>

#include "math/vec.h"
#include "sampling/warp.h"

namespace candela {

/// A well mixed function of its argument: Chris Wellons, "Prospecting for hash functions", 2018.
constexpr uint32_t Hash(uint32_t x) {
  x = (x ^ x >> 16) * 0x7feb352d;
  x = (x ^ x >> 15) * 0x846ca68b;
  return x ^ x >> 16;
}
constexpr uint32_t Hash(uint32_t a, uint32_t b) {
  return Hash(Hash(a) + b * 0x9e3779b9);
}

/// Random numbers that are the same on every machine: hashes of a seed and a counter.
class Random {
 public:
  explicit Random(uint32_t seed) : seed_(seed) {}

  /// 0 <= x < 1.
  float Real() { return static_cast<float>(Integer() >> 8) * 0x1p-24f; }
  float Between(float low, float high) { return low + (high - low) * Real(); }
  /// Below `count`.
  uint32_t Below(uint32_t count) {
    return static_cast<uint32_t>(uint64_t{Integer()} * count >> 32);
  }
  Vec2 Pair() {
    const float x = Real();
    return {x, Real()};
  }
  /// A point between two corners of a box.
  Vec3 Point(Vec3 low, Vec3 high) {
    const float x = Between(low.x, high.x);
    const float y = Between(low.y, high.y);
    return {x, y, Between(low.z, high.z)};
  }
  /// A unit vector.
  Vec3 Direction() { return SampleUniformSphere(Pair()); }

 private:
  uint32_t Integer() { return Hash(seed_, counter_++); }

  uint32_t seed_;
  uint32_t counter_ = 0;
};

}  // namespace candela
