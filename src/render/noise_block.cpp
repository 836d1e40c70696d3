#include "render/noise_block.h"

#include <algorithm>
#include <cmath>

#include "film/pixel_estimate.h"

namespace candela {
namespace {

// Too few samples say too little of how much they differ.
constexpr uint32_t kFirstSamples = 16;
// Then a part of what there is, so that questions cost little and nothing is rendered for long
// after it is good enough.
constexpr uint32_t kLeastMore = 8, kPartMore = 8;

float Luminance(Rgb colour) {
  return 0.2126f * colour.x + 0.7152f * colour.y + 0.0722f * colour.z;
}

}  // namespace

NoiseBlock::NoiseBlock(const PixelWindow& window, const RenderOptions& options, const Film& film)
    : target_(*options.noise_target), most_(options.samples / 2 + options.samples % 2) {
  for (FilmTile& tile : running_) film.BeginSeries(window, &tile);
}

bool NoiseBlock::Advance(SampleTracer* tracer) {
  const uint32_t more = done_ == 0 ? kFirstSamples : std::max(kLeastMore, done_ / kPartMore);
  const uint32_t end = done_ + std::min(more, most_ - done_);
  for (uint32_t series = 0; series < 2; ++series) {
    if (!tracer->Trace({done_, end, series}, &running_[series])) return false;
    running_[series].ShareVariance();
  }
  done_ = end;
  End();
  return true;
}

/// Ends the series that have enough.
void NoiseBlock::End() {
  const std::array quiet = {IsQuiet(running_[0]), IsQuiet(running_[1])};
  for (size_t i = 0; i < 2; ++i) {
    if (ended_[i]) continue;
    samples_[i] = done_;
    ended_[i] = quiet[1 - i] || done_ == most_;
    if (!quiet[1 - i] && done_ == most_) missed_ = true;
  }
  if (IsDone()) return;
  for (size_t i = 0; i < 2; ++i) {
    if (ended_[i] && samples_[i] == done_) kept_[i] = running_[i];
  }
}

bool NoiseBlock::IsQuiet(const FilmTile& tile) const {
  if (done_ < 2) return false;  // One sample does not tell how far it may be off.
  const PixelWindow& window = tile.Window();
  size_t noisy = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const PixelPart part = tile.PartAt(x, y);
      const PixelEstimate pixel({&part, 1});
      // The mean of two such series has half of the variance.
      const float error = Luminance(pixel.StandardError()) * 0.70710678f;
      // The course's lights may take away.
      if (error > target_ * std::abs(Luminance(pixel.Colour()))) ++noisy;
    }
  }
  return static_cast<double>(noisy) <= kNoisyPart * static_cast<double>(window.PixelCount());
}

}  // namespace candela
