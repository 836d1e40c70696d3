#pragma once

#include <algorithm>
#include <cstdint>

#include "film/film.h"

namespace candela {

/// Cuts a window into square tiles, row after row; those at the right and lower edge may be
/// smaller.
class Tiles {
 public:
  Tiles(const PixelWindow& window, int size)
      : window_(window), size_(size), columns_((int64_t{window.Width()} + size - 1) / size) {}

  int64_t Columns() const { return columns_; }
  int64_t Rows() const { return (int64_t{window_.Height()} + size_ - 1) / size_; }
  int64_t Count() const { return Columns() * Rows(); }

  /// Where a row of tiles ends, counted from the top of the window.
  int RowEnd(int64_t row) const {
    return static_cast<int>(std::min<int64_t>((row + 1) * size_, window_.Height()));
  }

  PixelWindow Window(int64_t tile) const {
    const int x0 = window_.x0 + static_cast<int>(tile % columns_) * size_;
    const int y0 = window_.y0 + static_cast<int>(tile / columns_) * size_;
    return {x0, y0, std::min(x0 + size_, window_.x1), std::min(y0 + size_, window_.y1)};
  }

 private:
  PixelWindow window_;
  int size_;
  int64_t columns_;
};

}  // namespace candela
