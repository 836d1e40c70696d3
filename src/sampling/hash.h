#pragma once

#include <cstdint>

namespace candela {

/// A bijection that spreads every bit over all 64: the finaliser of SplitMix64 (Steele, Lea and
/// Flood, "Fast splittable pseudorandom number generators", 2014).
inline uint64_t MixBits(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Joins a hash and one more value; the odd constant keeps a value of 0 from leaving the hash
/// alone.
inline uint64_t MixBits(uint64_t hash, uint64_t value) {
  return MixBits(hash ^ (value + 0x9e3779b97f4a7c15u));
}

inline uint32_t LowHalf(uint64_t x) {
  return static_cast<uint32_t>(x);
}
inline uint32_t HighHalf(uint64_t x) {
  return static_cast<uint32_t>(x >> 32);
}

/// A multiple of 2^-24 in [0, 1), of the upper bits.
inline float ToUnitInterval(uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

}  // namespace candela
