#include "sampling/sobol_block.h"

#include "base/run_vectorized.h"
#include "sampling/hash.h"
#include "sampling/scrambled_sobol.h"

namespace candela::sobol {
namespace {

[[gnu::always_inline]] inline void Find(uint32_t dimension, bool are_pairs, Block* block) {
  std::array<uint32_t, Block::kSize> seeds, seeds_x, seeds_y;
  for (size_t i = 0; i < Block::kSize; ++i) {
    const uint64_t hash = MixBits(block->pixel_hashes[i], dimension);
    seeds[i] = LowHalf(hash);
    seeds_x[i] = HighHalf(hash);
    if (are_pairs) seeds_y[i] = LowHalf(MixBits(hash));
  }
  for (size_t i = 0; i < Block::kSize; ++i) {
    const uint32_t index = Shuffle(block->reversed_indices[i], seeds[i]);
    block->x[i] = ScrambledPoint(index, seeds_x[i]);
    if (are_pairs) block->y[i] = ScrambledPoint(PascalMatrix(index), seeds_y[i]);
  }
}

}  // namespace

void FindPoints(uint32_t dimension, Block* block) {
  RunVectorized([=]() __attribute__((always_inline)) { Find(dimension, false, block); });
}

void FindPairsOfPoints(uint32_t dimension, Block* block) {
  RunVectorized([=]() __attribute__((always_inline)) { Find(dimension, true, block); });
}

}  // namespace candela::sobol
