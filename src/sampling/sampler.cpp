#include "sampling/sampler.h"

#include <algorithm>
#include <bit>

namespace candela {
namespace {

constexpr SamplerEntry kSamplers[] = {
    {"sobol", "scrambled Sobol points, even for any number of samples", SamplerKind::kSobol, true},
    {"stratified", "blocks of 4x4 strata", SamplerKind::kStratified, true},
    {"independent", "dice, for comparison", SamplerKind::kIndependent, true},
    {"blue_noise", "Sobol points for --samples whose noise is fine-grained",
     SamplerKind::kBlueNoise, false},
};

constexpr uint32_t kStrata = 16;
constexpr int kMostBlueBits = 16;

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

/// The bits of each byte, from the other end.
template <class Word>
Word ReverseBitsOfBytes(Word x) {
  constexpr Word kOnes = ~Word{0};
  x = ((x >> 4) & (kOnes / 17)) | ((x & (kOnes / 17)) << 4);
  x = ((x >> 2) & (kOnes / 5)) | ((x & (kOnes / 5)) << 2);
  return ((x >> 1) & (kOnes / 3)) | ((x & (kOnes / 3)) << 1);
}

uint32_t ReverseBits(uint32_t x) {
  return ReverseBitsOfBytes(__builtin_bswap32(x));
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

uint32_t LowHalf(uint64_t x) {
  return static_cast<uint32_t>(x);
}
uint32_t HighHalf(uint64_t x) {
  return static_cast<uint32_t>(x >> 32);
}

float ToUnitInterval(uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// The point of a scrambled sequence whose digits are `digits` from the lowest bit up.
float ScrambledPoint(uint32_t digits, uint32_t seed) {
  return ToUnitInterval(ReverseBits(ScrambleUpwards(digits, seed)));
}

/// Two of them.
Vec2 ScrambledPoints(uint32_t digits_x, uint32_t seed_x, uint32_t digits_y, uint32_t seed_y) {
  const uint64_t both =
      (uint64_t{ScrambleUpwards(digits_x, seed_x)} << 32) | ScrambleUpwards(digits_y, seed_y);
  // All bytes swapped, x is the low half.
  const uint64_t reversed = ReverseBitsOfBytes(__builtin_bswap64(both));
  return {ToUnitInterval(LowHalf(reversed)), ToUnitInterval(HighHalf(reversed))};
}

/// Permutes the samples of a sequence such that aligned blocks of 2^k stay together. The index is
/// given with its bits reversed.
uint32_t Shuffle(uint32_t reversed_index, uint32_t seed) {
  return ReverseBits(ScrambleUpwards(reversed_index, seed));
}

/// The place of i among a random permutation of 0 to count - 1, where count is a power of two up to
/// 16: Kensler's hash.
uint32_t Permute(uint32_t i, uint32_t count, uint32_t seed) {
  const uint32_t mask = count - 1;
  i ^= seed;
  i *= 0xe170893du;
  i ^= seed >> 16;
  i ^= (i & mask) >> 4;
  i ^= seed >> 8;
  i *= 0x0929eb3fu;
  i ^= seed >> 23;
  i ^= (i & mask) >> 1;
  i *= 1 | seed >> 27;
  i *= 0x6935fa69u;
  i ^= (i & mask) >> 11;
  i *= 0x74dcb303u;
  i ^= (i & mask) >> 2;
  i *= 0x9e501cc3u;
  i ^= (i & mask) >> 2;
  i *= 0xc860a3dfu;
  i &= mask;
  i ^= i >> 5;
  return (i + seed) & mask;
}

/// The bits of a 16-bit number with a 0 before each.
uint32_t SpreadBits(uint32_t x) {
  x = (x | (x << 8)) & 0x00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

/// The place of a pixel along the curve of G. Morton (1966).
uint32_t ZOrder(uint32_t x, uint32_t y) {
  return SpreadBits(x) | (SpreadBits(y) << 1);
}

}  // namespace

SamplerType::SamplerType(SamplerKind sampler, uint32_t samples) : kind(sampler) {
  if (kind != SamplerKind::kBlueNoise || samples < 2) return;
  log2_samples = static_cast<uint8_t>(std::min<int>(std::bit_width(samples - 1), kMostBlueBits));
}

std::span<const SamplerEntry> Samplers() {
  return kSamplers;
}

const SamplerEntry* FindSampler(std::string_view name) {
  const auto found = std::ranges::find(kSamplers, name, &SamplerEntry::name);
  return found == std::end(kSamplers) ? nullptr : found;
}

Sampler::Sampler(uint32_t seed, uint32_t pixel_x, uint32_t pixel_y, uint32_t sample_index,
                 SamplerType type)
    : pixel_hash_(Mix(Mix(seed), (uint64_t{pixel_y} << 32) | pixel_x)),
      sample_index_(sample_index),
      kind_(type.kind) {
  if (kind_ == SamplerKind::kSobol) sample_index_ = ReverseBits(sample_index);
  if (kind_ != SamplerKind::kBlueNoise) return;
  // One Sobol sequence for a square of pixels, as large as 32 bits let it be. The samples of a
  // pixel, of 2 x 2 pixels, and so on, are runs of it, and as even as such.
  const uint32_t bits = type.log2_samples, square_bits = (32 - bits) / 2;
  const uint32_t square_x = pixel_x >> square_bits, square_y = pixel_y >> square_bits;
  const uint32_t in_square = (uint32_t{1} << square_bits) - 1;
  const uint32_t in_block = (uint32_t{1} << bits) - 1;
  pixel_hash_ = Mix(Mix(Mix(seed), (uint64_t{square_y} << 32) | square_x), sample_index >> bits);
  sample_index_ = ReverseBits((ZOrder(pixel_x & in_square, pixel_y & in_square) << bits) |
                              (sample_index & in_block));
  kind_ = SamplerKind::kSobol;
}

float Sampler::Stratified1D(uint64_t hash) const {
  const uint64_t block = Mix(hash, sample_index_ / kStrata);
  const uint32_t stratum = Permute(sample_index_ % kStrata, kStrata, LowHalf(block));
  const auto within = static_cast<uint32_t>(Mix(hash, ~uint64_t{sample_index_}) >> 44);
  return ToUnitInterval((stratum << 28) | (within << 8));
}

// Each square of the 4 x 4 holds one sample, and so do each of 16 columns and of 16 rows.
Vec2 Sampler::Stratified2D(uint64_t hash) const {
  const uint64_t block = Mix(hash, sample_index_ / kStrata);
  const uint32_t square = Permute(sample_index_ % kStrata, kStrata, LowHalf(block));
  const uint32_t column = square % 4, row = square / 4;
  const uint32_t fine_column = Permute(row, 4, HighHalf(block));
  const uint32_t fine_row = Permute(column, 4, LowHalf(Mix(block)));
  const uint64_t within = Mix(hash, ~uint64_t{sample_index_});
  return {ToUnitInterval((column << 30) | (fine_column << 28) | (LowHalf(within) >> 4)),
          ToUnitInterval((row << 30) | (fine_row << 28) | (HighHalf(within) >> 4))};
}

float Sampler::Get1D(uint32_t dimension) const {
  const uint64_t hash = Mix(pixel_hash_, dimension);
  if (kind_ == SamplerKind::kIndependent) {
    return ToUnitInterval(LowHalf(Mix(hash, sample_index_)));
  }
  if (kind_ == SamplerKind::kStratified) return Stratified1D(hash);
  // The first Sobol sequence has the digits of the index itself.
  return ScrambledPoint(Shuffle(sample_index_, LowHalf(hash)), HighHalf(hash));
}

Vec2 Sampler::Get2D(uint32_t dimension) const {
  const uint64_t hash = Mix(pixel_hash_, dimension);
  if (kind_ == SamplerKind::kIndependent) {
    const uint64_t bits = Mix(hash, sample_index_);
    return {ToUnitInterval(LowHalf(bits)), ToUnitInterval(HighHalf(bits))};
  }
  if (kind_ == SamplerKind::kStratified) return Stratified2D(hash);
  const uint32_t index = Shuffle(sample_index_, LowHalf(hash));
  return ScrambledPoints(index, HighHalf(hash), PascalMatrix(index), LowHalf(Mix(hash)));
}

}  // namespace candela
