#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"

namespace candela {

/// A rectangle of pixels with the same number of samples each. The top row comes first, a row goes
/// from left to right, the samples of a pixel stand together.
template <class T>
class Raster {
 public:
  Raster() = default;

  /// All samples are `fill`. Sizes from files go through `CheckImageSize` first.
  Raster(int width, int height, int channels, T fill = T())
      : width_(width), height_(height), channels_(channels) {
    CHECK(width >= 0 && height >= 0 && channels >= 1);
    samples_.assign(RowSize() * static_cast<size_t>(height), fill);
  }

  int Width() const { return width_; }
  int Height() const { return height_; }
  int Channels() const { return channels_; }
  int64_t PixelCount() const { return int64_t{width_} * height_; }
  bool IsEmpty() const { return samples_.empty(); }

  /// Samples in one row.
  size_t RowSize() const { return static_cast<size_t>(width_) * static_cast<size_t>(channels_); }

  std::span<T> Row(int y) { return {samples_.data() + RowOffset(y), RowSize()}; }
  std::span<const T> Row(int y) const { return {samples_.data() + RowOffset(y), RowSize()}; }

  /// The samples of one pixel.
  std::span<T> Pixel(int x, int y) { return Row(y).subspan(Column(x), Depth()); }
  std::span<const T> Pixel(int x, int y) const { return Row(y).subspan(Column(x), Depth()); }

  T& At(int x, int y, int c = 0) { return samples_[Offset(x, y, c)]; }
  const T& At(int x, int y, int c = 0) const { return samples_[Offset(x, y, c)]; }

  /// Everything, row after row.
  std::span<T> Samples() { return samples_; }
  std::span<const T> Samples() const { return samples_; }

  friend bool operator==(const Raster&, const Raster&) = default;

 private:
  size_t Depth() const { return static_cast<size_t>(channels_); }
  size_t Column(int x) const {
    DCHECK(x >= 0 && x < width_);
    return static_cast<size_t>(x) * Depth();
  }
  size_t RowOffset(int y) const {
    DCHECK(y >= 0 && y < height_);
    return static_cast<size_t>(y) * RowSize();
  }
  size_t Offset(int x, int y, int c) const {
    DCHECK(c >= 0 && c < channels_);
    return RowOffset(y) + Column(x) + static_cast<size_t>(c);
  }

  int width_ = 0;
  int height_ = 0;
  int channels_ = 1;
  std::vector<T> samples_;
};

/// Linear values without a range: radiance, depth, normals.
using Image = Raster<float>;
/// What 8-bit and 16-bit files hold. One channel is grey, two are grey and alpha, three are red,
/// green and blue, four have alpha too.
using ByteImage = Raster<uint8_t>;
using WordImage = Raster<uint16_t>;

}  // namespace candela
