#include "sampling/sobol_block.h"

#include "base/isa.h"
#include "sampling/hash.h"
#include "sampling/scrambled_sobol.h"

namespace candela::sobol {
namespace {

// What follows is compiled for each instruction set, as a part of the functions behind it: loops of
// known length and without branches, from which the compiler makes vector code where it inlines
// what they call. Where it does not, the inline functions are those of every processor: only these
// functions here are compiled for a set.

[[gnu::always_inline]] inline void FindAny(uint32_t dimension, bool are_pairs, Block* block) {
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

void FindScalar(uint32_t dimension, bool are_pairs, Block* block) {
  are_pairs ? FindAny(dimension, true, block) : FindAny(dimension, false, block);
}

#ifdef CANDELA_X86
[[gnu::target("avx2")]] void FindAvx2(uint32_t dimension, bool are_pairs, Block* block) {
  are_pairs ? FindAny(dimension, true, block) : FindAny(dimension, false, block);
}

[[gnu::target("avx512f,avx512vl,avx512dq,avx512bw")]] void FindAvx512(uint32_t dimension,
                                                                      bool are_pairs,
                                                                      Block* block) {
  are_pairs ? FindAny(dimension, true, block) : FindAny(dimension, false, block);
}
#endif

void Find(uint32_t dimension, bool are_pairs, Block* block) {
  switch (DefaultIsa()) {
#ifdef CANDELA_X86
    case Isa::kAvx512:
      return FindAvx512(dimension, are_pairs, block);
    case Isa::kAvx2:
      return FindAvx2(dimension, are_pairs, block);
#endif
    default:
      return FindScalar(dimension, are_pairs, block);
  }
}

}  // namespace

void FindPoints(uint32_t dimension, Block* block) {
  Find(dimension, false, block);
}

void FindPairsOfPoints(uint32_t dimension, Block* block) {
  Find(dimension, true, block);
}

}  // namespace candela::sobol
