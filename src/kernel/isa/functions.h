#pragma once

#include "kernel/moving_lanes.h"
#include "kernel/trace_functions.h"
#include "kernel/trace_one.h"
#include "kernel/trace_packet.h"
#include "kernel/trace_span.h"

namespace candela::kernel {

/// All searches with some lanes.
template <class L>
constexpr TraceFunctions SearchesWith() {
  return {L::kWidth,
          &IntersectOne<L>,
          &OccludedOne<L>,
          &IntersectScattered<L>,
          &OccludedScattered<L>,
          &IntersectCoherent<L>,
          &OccludedCoherent<L>};
}

/// All searches with the lanes of an instruction set.
template <class L>
constexpr IsaFunctions FunctionsFor() {
  return {SearchesWith<L>(), SearchesWith<MovingLanes<L>>()};
}

}  // namespace candela::kernel
