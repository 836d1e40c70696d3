#pragma once

#include <cstdint>

#include "math/vec.h"

namespace candela {

/// What is nearest to a place, of points of which each cell of the lattice of whole points has one.
struct CellPoints {
  float nearest, second;  ///< The distances of the two nearest, the nearest one first.
  uint32_t cell;          ///< A number that belongs to the nearest one.
};

/// Worley, "A Cellular Texture Basis Function", 1996. Points lie in the middle of their cells, or
/// anywhere in them when `jitter` is 1. Exact, for places with coordinates below 2^30.
CellPoints NearestCellPoints(Vec3 p, float jitter);

}  // namespace candela
