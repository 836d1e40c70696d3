#include "film/splat_film.h"

#include "base/check.h"

namespace candela {

SplatFilm::SplatFilm(const PixelWindow& window)
    : window_(window),
      sums_(static_cast<size_t>(window.Width()) * static_cast<size_t>(window.Height())) {}

size_t SplatFilm::IndexOf(int x, int y) const {
  DCHECK(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  return static_cast<size_t>(y - window_.y0) * static_cast<size_t>(window_.Width()) +
         static_cast<size_t>(x - window_.x0);
}

void SplatFilm::Add(int x, int y, Rgb value) {
  if (!IsFinite(value)) {
    dropped_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  const size_t index = IndexOf(x, y);
  const std::lock_guard lock(guards_[index % guards_.size()]);
  sums_[index].red.Add(value.x);
  sums_[index].green.Add(value.y);
  sums_[index].blue.Add(value.z);
}

Rgb SplatFilm::Mean(int x, int y, uint64_t paths) const {
  const Sums& sums = sums_[IndexOf(x, y)];
  const auto count = static_cast<double>(paths);
  return ToFloat(
      {sums.red.ToDouble() / count, sums.green.ToDouble() / count, sums.blue.ToDouble() / count});
}

}  // namespace candela
