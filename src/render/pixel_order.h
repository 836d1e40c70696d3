#pragma once

#include <algorithm>

#include "film/film.h"

namespace candela {

/// Calls `visit(x, y)` for each pixel of a window, in blocks of 4 x 4, so that sixteen rays in a
/// row go nearly the same way. Stops when a visit returns false.
template <class Visit>
void ForEachPixel(const PixelWindow& window, Visit visit) {
  constexpr int kBlock = 4;
  for (int y0 = window.y0; y0 < window.y1; y0 += kBlock) {
    for (int x0 = window.x0; x0 < window.x1; x0 += kBlock) {
      const int x1 = std::min(x0 + kBlock, window.x1), y1 = std::min(y0 + kBlock, window.y1);
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          if (!visit(x, y)) return;
        }
      }
    }
  }
}

}  // namespace candela
