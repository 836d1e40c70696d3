#pragma once

#include <cstdint>

#include "math/vec.h"

namespace candela {

/// Smooth noise around 0 without a period in sight, from -1 to 1, 0 at all whole points and beyond
/// 2^30: Perlin, "Improving Noise", 2002, with a hash in place of his table.
float GradientNoise(Vec3 p);

/// The mean magnitude of that.
inline constexpr float kMeanGradientNoise = 0.2202f;

/// A number without relation to those of other cells of the lattice of whole points, by the
/// finaliser of A. Appleby's MurmurHash3.
inline uint32_t HashOfCell(int32_t x, int32_t y, int32_t z) {
  uint32_t h = static_cast<uint32_t>(x) * 0x8DA6B343u ^ static_cast<uint32_t>(y) * 0xD8163841u ^
               static_cast<uint32_t>(z) * 0xCB1AB31Fu;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return h ^ (h >> 16);
}

}  // namespace candela
