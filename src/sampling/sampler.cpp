#include "sampling/sampler.h"

namespace candela {
namespace {

/// A bijection that spreads every bit over all 64: the finaliser of SplitMix64 (Steele, Lea and
/// Flood, "Fast splittable pseudorandom number generators", 2014).
uint64_t Mix(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Joins a hash and one more value; the odd constant keeps a value of 0 from leaving the hash
/// alone.
uint64_t Mix(uint64_t hash, uint64_t value) {
  return Mix(hash ^ (value + 0x9e3779b97f4a7c15u));
}

uint32_t ReverseBits(uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// A random permutation in which each bit depends only on the bits below it: Owen's scrambling of
/// the fraction whose digits are `x` from the lowest bit up. The construction is that of S. Laine
/// and T. Karras, "Stratified sampling for stochastic transparency" (2011), with N. Vegdahl's
/// constants.
uint32_t ScrambleUpwards(uint32_t x, uint32_t seed) {
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
uint32_t PascalMatrix(uint32_t index) {
  index ^= (index & 0xaaaaaaaau) >> 1;
  index ^= (index & 0xccccccccu) >> 2;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xff00ff00u) >> 8;
  index ^= (index & 0xffff0000u) >> 16;
  return index;
}

float ToUnitInterval(uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// The point of a scrambled sequence whose digits are `digits` from the lowest bit up.
float ScrambledPoint(uint32_t digits, uint32_t seed) {
  return ToUnitInterval(ReverseBits(ScrambleUpwards(digits, seed)));
}

/// Permutes the samples of a sequence such that aligned blocks of 2^k stay together.
uint32_t Shuffle(uint32_t index, uint32_t seed) {
  return ReverseBits(ScrambleUpwards(ReverseBits(index), seed));
}

uint32_t LowHalf(uint64_t x) {
  return static_cast<uint32_t>(x);
}
uint32_t HighHalf(uint64_t x) {
  return static_cast<uint32_t>(x >> 32);
}

}  // namespace

Sampler::Sampler(uint32_t seed, uint32_t pixel_x, uint32_t pixel_y, uint32_t sample_index,
                 SamplerKind kind)
    : pixel_hash_(Mix(Mix(seed), (uint64_t{pixel_y} << 32) | pixel_x)),
      sample_index_(sample_index),
      kind_(kind) {}

float Sampler::Get1D(uint32_t dimension) const {
  const uint64_t hash = Mix(pixel_hash_, dimension);
  if (kind_ == SamplerKind::kIndependent) {
    return ToUnitInterval(LowHalf(Mix(hash, sample_index_)));
  }
  // The first Sobol sequence has the digits of the index itself.
  return ScrambledPoint(Shuffle(sample_index_, LowHalf(hash)), HighHalf(hash));
}

Vec2 Sampler::Get2D(uint32_t dimension) const {
  const uint64_t hash = Mix(pixel_hash_, dimension);
  if (kind_ == SamplerKind::kIndependent) {
    const uint64_t bits = Mix(hash, sample_index_);
    return {ToUnitInterval(LowHalf(bits)), ToUnitInterval(HighHalf(bits))};
  }
  const uint32_t index = Shuffle(sample_index_, LowHalf(hash));
  return {ScrambledPoint(index, HighHalf(hash)),
          ScrambledPoint(PascalMatrix(index), LowHalf(Mix(hash)))};
}

}  // namespace candela
