#include "image/adam7.h"

namespace candela {

std::span<const PngPass> PngPasses(bool interlaced) {
  static constexpr PngPass kPlain[] = {{0, 0, 1, 1}};
  static constexpr PngPass kAdam7[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                       {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  if (interlaced) return kAdam7;
  return kPlain;
}

}  // namespace candela
