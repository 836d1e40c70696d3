#include "film/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace candela {
namespace {

/// Written so that NaN is not usable. Negative light is: the course's model knows lights that take
/// away, and a channel below 0 is not to darken the others.
bool IsUsable(float radiance) {
  return std::abs(radiance) <= std::numeric_limits<float>::max();
}

bool IsUsable(Rgb radiance) {
  return IsUsable(radiance.x) && IsUsable(radiance.y) && IsUsable(radiance.z);
}

size_t PixelCount(const PixelWindow& window) {
  return static_cast<size_t>(window.Width()) * static_cast<size_t>(window.Height());
}

}  // namespace

void PixelSums::Add(Rgb radiance, float sample_weight) {
  red.Add(radiance.x * sample_weight);
  green.Add(radiance.y * sample_weight);
  blue.Add(radiance.z * sample_weight);
  weight.Add(sample_weight);
}

Rgb PixelSums::Mean() const {
  const double divisor = weight.ToDouble();
  if (divisor == 0) return {};
  return ToFloat({red.ToDouble() / divisor, green.ToDouble() / divisor, blue.ToDouble() / divisor});
}

void FilmTile::Add(int x, int y, Rgb radiance, float weight) {
  DCHECK(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  if (!IsUsable(radiance)) {
    ++dropped_samples_;
    return;
  }
  const int column = x - window_.x0;
  const int row = y - window_.y0;
  sums_[static_cast<size_t>(row) * static_cast<size_t>(window_.Width()) +
        static_cast<size_t>(column)]
      .Add(radiance, weight);
}

Film::Film(PixelWindow window, Keep keep) : window_(window), colours_(3 * PixelCount(window)) {
  CHECK(window.x0 < window.x1 && window.y0 < window.y1);
  if (keep == Keep::kSums) sums_ = ZeroedArray<PixelSums>(PixelCount(window));
}

size_t Film::IndexOf(int x, int y) const {
  DCHECK(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  return static_cast<size_t>(y - window_.y0) * static_cast<size_t>(window_.Width()) +
         static_cast<size_t>(x - window_.x0);
}

void Film::BeginTile(const PixelWindow& window, FilmTile* tile) const {
  CHECK(window_.Contains(window));
  tile->window_ = window;
  tile->dropped_samples_ = 0;
  tile->sums_.assign(PixelCount(window), PixelSums());
  if (!sums_) return;
  const auto width = static_cast<size_t>(window.Width());
  for (int y = window.y0; y < window.y1; ++y) {
    std::copy_n(&sums_[IndexOf(window.x0, y)], width,
                &tile->sums_[static_cast<size_t>(y - window.y0) * width]);
  }
}

void Film::EndTile(const FilmTile& tile) {
  const PixelSums* sums = tile.sums_.data();
  for (int y = tile.window_.y0; y < tile.window_.y1; ++y) {
    for (int x = tile.window_.x0; x < tile.window_.x1; ++x, ++sums) {
      const size_t index = IndexOf(x, y);
      const Rgb colour = sums->Mean();
      colours_[3 * index] = colour.x;
      colours_[3 * index + 1] = colour.y;
      colours_[3 * index + 2] = colour.z;
      if (sums_) sums_[index] = *sums;
    }
  }
  dropped_samples_.fetch_add(tile.dropped_samples_, std::memory_order_relaxed);
}

void Film::SetOnlySample(int x, int y, Rgb radiance) {
  DCHECK(!sums_);
  if (!IsUsable(radiance)) {
    dropped_samples_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  // 0, and floats from 2^-20 on, are multiples of what a sum resolves.
  const auto developed = [](float value) {
    const bool is_exact = value == 0 || (value >= 0x1p-20f && value <= ExactSum::kLargestTerm);
    return is_exact ? value : static_cast<float>(ExactSum::OfOne(value));
  };
  float* colour = &colours_[3 * IndexOf(x, y)];
  colour[0] = developed(radiance.x);
  colour[1] = developed(radiance.y);
  colour[2] = developed(radiance.z);
}

void Film::AddToColour(int x, int y, Rgb radiance) {
  float* colour = &colours_[3 * IndexOf(x, y)];
  colour[0] += radiance.x;
  colour[1] += radiance.y;
  colour[2] += radiance.z;
}

Rgb Film::Pixel(int x, int y) const {
  const float* colour = &colours_[3 * IndexOf(x, y)];
  return {colour[0], colour[1], colour[2]};
}

std::span<const float> Film::Row(int y) const {
  return {&colours_[3 * IndexOf(window_.x0, y)], 3 * static_cast<size_t>(window_.Width())};
}

}  // namespace candela
