#include "sampling/sampler.h"

#include <algorithm>
#include <bit>

#include "base/check.h"
#include "sampling/hash.h"
#include "sampling/sobol_block.h"

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
    : pixel_hash_(MixBits(MixBits(seed), (uint64_t{pixel_y} << 32) | pixel_x)),
      sample_index_(sample_index),
      kind_(type.kind) {
  if (kind_ == SamplerKind::kSobol) sample_index_ = sobol::ReverseBits(sample_index);
  if (kind_ != SamplerKind::kBlueNoise) return;
  // One Sobol sequence for a square of pixels, as large as 32 bits let it be. The samples of a
  // pixel, of 2 x 2 pixels, and so on, are runs of it, and as even as such.
  const uint32_t bits = type.log2_samples, square_bits = (32 - bits) / 2;
  const uint32_t square_x = pixel_x >> square_bits, square_y = pixel_y >> square_bits;
  const uint32_t in_square = (uint32_t{1} << square_bits) - 1;
  const uint32_t in_block = (uint32_t{1} << bits) - 1;
  pixel_hash_ =
      MixBits(MixBits(MixBits(seed), (uint64_t{square_y} << 32) | square_x), sample_index >> bits);
  sample_index_ = sobol::ReverseBits((ZOrder(pixel_x & in_square, pixel_y & in_square) << bits) |
                                     (sample_index & in_block));
  kind_ = SamplerKind::kSobol;
}

template <class Find, class Take>
void Sampler::FindInBlocks(std::span<const Sampler> samplers, Find find, Take take) {
  sobol::Block block;
  DCHECK(std::ranges::all_of(samplers,
                             [](const Sampler& one) { return one.kind_ == SamplerKind::kSobol; }));
  for (size_t begin = 0; begin < samplers.size(); begin += sobol::Block::kSize) {
    const size_t count = std::min(sobol::Block::kSize, samplers.size() - begin);
    for (size_t k = 0; k < count; ++k) {
      block.pixel_hashes[k] = samplers[begin + k].pixel_hash_;
      block.reversed_indices[k] = samplers[begin + k].sample_index_;
    }
    find(&block);
    for (size_t k = 0; k < count; ++k) take(begin + k, block, k);
  }
}

void Sampler::Get1D(std::span<const Sampler> samplers, uint32_t dimension,
                    std::span<float> numbers) {
  if (samplers.empty() || samplers[0].kind_ == SamplerKind::kSobol) {
    return FindInBlocks(
        samplers, [&](sobol::Block* block) { sobol::FindPoints(dimension, block); },
        [&](size_t i, const sobol::Block& block, size_t k) { numbers[i] = block.x[k]; });
  }
  for (size_t i = 0; i < samplers.size(); ++i) numbers[i] = samplers[i].Get1D(dimension);
}

void Sampler::Get2D(std::span<const Sampler> samplers, uint32_t dimension, std::span<Vec2> pairs) {
  if (samplers.empty() || samplers[0].kind_ == SamplerKind::kSobol) {
    return FindInBlocks(
        samplers, [&](sobol::Block* block) { sobol::FindPairsOfPoints(dimension, block); },
        [&](size_t i, const sobol::Block& block, size_t k) {
          pairs[i] = {block.x[k], block.y[k]};
        });
  }
  for (size_t i = 0; i < samplers.size(); ++i) pairs[i] = samplers[i].Get2D(dimension);
}

float Sampler::Stratified1D(uint64_t hash) const {
  const uint64_t block = MixBits(hash, sample_index_ / kStrata);
  const uint32_t stratum = Permute(sample_index_ % kStrata, kStrata, LowHalf(block));
  const auto within = static_cast<uint32_t>(MixBits(hash, ~uint64_t{sample_index_}) >> 44);
  return ToUnitInterval((stratum << 28) | (within << 8));
}

// Each square of the 4 x 4 holds one sample, and so do each of 16 columns and of 16 rows.
Vec2 Sampler::Stratified2D(uint64_t hash) const {
  const uint64_t block = MixBits(hash, sample_index_ / kStrata);
  const uint32_t square = Permute(sample_index_ % kStrata, kStrata, LowHalf(block));
  const uint32_t column = square % 4, row = square / 4;
  const uint32_t fine_column = Permute(row, 4, HighHalf(block));
  const uint32_t fine_row = Permute(column, 4, LowHalf(MixBits(block)));
  const uint64_t within = MixBits(hash, ~uint64_t{sample_index_});
  return {ToUnitInterval((column << 30) | (fine_column << 28) | (LowHalf(within) >> 4)),
          ToUnitInterval((row << 30) | (fine_row << 28) | (HighHalf(within) >> 4))};
}

float Sampler::Other1D(uint64_t hash) const {
  if (kind_ == SamplerKind::kStratified) return Stratified1D(hash);
  return ToUnitInterval(LowHalf(MixBits(hash, sample_index_)));
}

Vec2 Sampler::Other2D(uint64_t hash) const {
  if (kind_ == SamplerKind::kStratified) return Stratified2D(hash);
  const uint64_t bits = MixBits(hash, sample_index_);
  return {ToUnitInterval(LowHalf(bits)), ToUnitInterval(HighHalf(bits))};
}

}  // namespace candela
