#pragma once

#include <cstdint>
#include <span>

namespace candela {

/// One of the reduced pictures that a PNG is stored as: every `step_x`-th pixel of every
/// `step_y`-th row, beginning at (first_x, first_y).
struct PngPass {
  int first_x, first_y, step_x, step_y;

  /// Size of the reduced picture of a whole of that size; 0 when the pass is empty.
  int64_t Width(int64_t whole) const { return (whole - first_x + step_x - 1) / step_x; }
  int64_t Height(int64_t whole) const { return (whole - first_y + step_y - 1) / step_y; }
};

/// The seven passes of an interlaced file (ISO/IEC 15948, clause 8), or the single one of a plain
/// file.
std::span<const PngPass> PngPasses(bool interlaced);

}  // namespace candela
