#include "film/splat_film.h"

namespace candela {

SplatFilm::SplatFilm(const PixelWindow& window) : window_(window), sums_(window.PixelCount()) {}

void SplatFilm::Add(int x, int y, Rgb value) {
  if (!IsFinite(value)) {
    Drop();
    return;
  }
  const size_t index = window_.IndexOf(x, y);
  const std::lock_guard lock(guards_[index % guards_.size()]);
  sums_[index].red.Add(value.x);
  sums_[index].green.Add(value.y);
  sums_[index].blue.Add(value.z);
}

Rgb SplatFilm::Mean(int x, int y, uint64_t paths) const {
  const Sums& sums = sums_[window_.IndexOf(x, y)];
  const auto count = static_cast<double>(paths);
  return ToFloat(
      {sums.red.ToDouble() / count, sums.green.ToDouble() / count, sums.blue.ToDouble() / count});
}

}  // namespace candela
