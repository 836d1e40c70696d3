#pragma once

#include <cstdint>

#include "math/vec.h"
#include "sampling/hash.h"

/// Sobol points with hashed Owen scrambling, after B. Burley, "Practical hash-based Owen
/// scrambling" (JCGT 2020), and what they are made of. In a header: the steps of one point wait for
/// each other, and a caller has others to take meanwhile.
namespace candela::sobol {

/// The bits of each byte, from the other end.
template <class Word>
Word ReverseBitsOfBytes(Word x) {
  constexpr Word kOnes = ~Word{0};
  x = ((x >> 4) & (kOnes / 17)) | ((x & (kOnes / 17)) << 4);
  x = ((x >> 2) & (kOnes / 5)) | ((x & (kOnes / 5)) << 2);
  return ((x >> 1) & (kOnes / 3)) | ((x & (kOnes / 3)) << 1);
}

inline uint32_t ReverseBits(uint32_t x) {
  return ReverseBitsOfBytes(__builtin_bswap32(x));
}

/// A random permutation in which each bit depends only on the bits below it: Owen's scrambling of
/// the fraction whose digits are `x` from the lowest bit up. The construction is that of S. Laine
/// and T. Karras, "Stratified sampling for stochastic transparency" (2011), with N. Vegdahl's
/// constants.
inline uint32_t ScrambleUpwards(uint32_t x, uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Applies Pascal's triangle modulo 2 to the bits of the index: bit i of the result is the sum over
/// all j of (j over i) times bit j. It is the second generator matrix of Sobol's sequence; being
/// the fifth tensor power of [1 1; 0 1], it takes five steps.
inline uint32_t PascalMatrix(uint32_t index) {
  index ^= (index & 0xaaaaaaaau) >> 1;
  index ^= (index & 0xccccccccu) >> 2;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xff00ff00u) >> 8;
  index ^= (index & 0xffff0000u) >> 16;
  return index;
}

/// The point of a scrambled sequence whose digits are `digits` from the lowest bit up.
inline float ScrambledPoint(uint32_t digits, uint32_t seed) {
  return ToUnitInterval(ReverseBits(ScrambleUpwards(digits, seed)));
}

/// Two of them.
inline Vec2 ScrambledPoints(uint32_t digits_x, uint32_t seed_x, uint32_t digits_y,
                            uint32_t seed_y) {
  const uint64_t both =
      (uint64_t{ScrambleUpwards(digits_x, seed_x)} << 32) | ScrambleUpwards(digits_y, seed_y);
  // All bytes swapped, x is the low half.
  const uint64_t reversed = ReverseBitsOfBytes(__builtin_bswap64(both));
  return {ToUnitInterval(LowHalf(reversed)), ToUnitInterval(HighHalf(reversed))};
}

/// Permutes the samples of a sequence such that aligned blocks of 2^k stay together. The index is
/// given with its bits reversed.
inline uint32_t Shuffle(uint32_t reversed_index, uint32_t seed) {
  return ReverseBits(ScrambleUpwards(reversed_index, seed));
}

/// The point of the sample whose index, bits reversed, is `reversed_index`, in the sequence that
/// `hash` names.
inline float Point(uint32_t reversed_index, uint64_t hash) {
  // The first Sobol sequence has the digits of the index itself.
  return ScrambledPoint(Shuffle(reversed_index, LowHalf(hash)), HighHalf(hash));
}

/// The same of a sequence of pairs.
inline Vec2 PairOfPoints(uint32_t reversed_index, uint64_t hash) {
  const uint32_t index = Shuffle(reversed_index, LowHalf(hash));
  return ScrambledPoints(index, HighHalf(hash), PascalMatrix(index), LowHalf(MixBits(hash)));
}

}  // namespace candela::sobol
