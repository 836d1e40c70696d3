#pragma once

#include "kernel/trace_functions.h"
#include "kernel/trace_one.h"
#include "kernel/trace_packet.h"
#include "kernel/trace_span.h"

namespace candela::kernel {

/// All searches with the lanes of an instruction set.
template <class L>
constexpr TraceFunctions FunctionsFor() {
  return {L::kWidth,
          &IntersectOne<L>,
          &OccludedOne<L>,
          &IntersectScattered<L>,
          &OccludedScattered<L>,
          &IntersectCoherent<L>,
          &OccludedCoherent<L>};
}

}  // namespace candela::kernel
