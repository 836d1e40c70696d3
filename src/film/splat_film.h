#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>

#include "film/film.h"
#include "math/exact_sum.h"
#include "math/spectrum.h"

namespace candela {

/// The sums of what light paths bring to the pixels of a window. They land anywhere, at any time,
/// so there are sums for the whole window, and any thread may add to any of them. The sums are
/// exact: no order of the paths shows. 48 bytes per pixel.
class SplatFilm {
 public:
  explicit SplatFilm(const PixelWindow& window);

  const PixelWindow& Window() const { return window_; }

  /// Adds to the pixel (x, y) of the whole picture, which must lie in the window. A value with a
  /// NaN or infinite component is dropped and counted. May be called concurrently.
  void Add(int x, int y, Rgb value);

  /// Counts one that its maker does not take. May be called concurrently.
  void Drop() { dropped_.fetch_add(1, std::memory_order_relaxed); }

  /// The sum of a pixel over `paths`, above 0. Not while others add.
  Rgb Mean(int x, int y, uint64_t paths) const;

  uint64_t DroppedSplats() const { return dropped_.load(std::memory_order_relaxed); }

 private:
  struct Sums {
    ExactSum red, green, blue;
  };

  PixelWindow window_;
  ZeroedArray<Sums> sums_;
  /// Each guards every so many pixels of a row, so that threads seldom wait for each other.
  std::array<std::mutex, 256> guards_;
  std::atomic<uint64_t> dropped_ = 0;
};

}  // namespace candela
