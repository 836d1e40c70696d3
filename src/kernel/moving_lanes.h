#pragma once

namespace candela::kernel {

/// The lanes of an instruction set for searches in groups of which something moves: their loops
/// know moving nodes and leaves. Searches where everything rests are compiled without them, and pay
/// nothing.
template <class L>
struct MovingLanes : L {
  static constexpr bool kMoves = true;
};

}  // namespace candela::kernel
