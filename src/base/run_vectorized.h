#pragma once

#include "base/isa.h"

namespace candela {

namespace run_vectorized {

template <class Loop>
void Scalar(const Loop& loop) {
  loop();
}

#ifdef CANDELA_X86
template <class Loop>
[[gnu::target("avx2")]] void Avx2(const Loop& loop) {
  loop();
}

template <class Loop>
[[gnu::target("avx512f,avx512vl,avx512dq,avx512bw")]] void Avx512(const Loop& loop) {
  loop();
}
#endif

}  // namespace run_vectorized

/// Calls `loop` as it is compiled for the instruction set of `DefaultIsa`, with the same bits for
/// all of them. It is to be always inlined, and so is what it calls: only what is inlined is
/// compiled for a set, the rest is for every processor. Loops of known length and without branches
/// become vector code. Bits stay the same only since nothing is contracted (`-ffp-contract=off`).
template <class Loop>
void RunVectorized(const Loop& loop) {
  switch (DefaultIsa()) {
#ifdef CANDELA_X86
    case Isa::kAvx512:
      return run_vectorized::Avx512(loop);
    case Isa::kAvx2:
      return run_vectorized::Avx2(loop);
#endif
    default:
      return run_vectorized::Scalar(loop);
  }
}

}  // namespace candela
