#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace candela::sobol {

/// Points of many sequences, one of each, calculated side by side: in the vector registers of the
/// processor, with the bits that `Point` and `PairOfPoints` give.
struct Block {
  static constexpr size_t kSize = 64;

  // Entry i of each belongs to the same sequence. The first two are to be filled.
  std::array<uint64_t, kSize> pixel_hashes{};
  std::array<uint32_t, kSize> reversed_indices{};
  std::array<float, kSize> x, y;
};

/// The x of `Sampler::Get1D`.
void FindPoints(uint32_t dimension, Block* block);
/// The x and y of `Sampler::Get2D`.
void FindPairsOfPoints(uint32_t dimension, Block* block);

}  // namespace candela::sobol
