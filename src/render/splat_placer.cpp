#include "render/splat_placer.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace candela {
namespace {

/// Pixels along one axis; the end is exclusive.
struct Pixels {
  int begin, end;
};

/// Those of a window of which the centre c lies around a position: -radius <= position - c <
/// radius.
Pixels PixelsAround(float position, float radius, int begin, int end) {
  // Written so that NaN lies around none.
  const auto limited = [=](float pixel) {
    const float below = std::min(pixel, static_cast<float>(end));
    return static_cast<int>(std::max(static_cast<float>(begin), below));
  };
  return {limited(std::floor(position - radius) + 1), limited(std::floor(position + radius) + 1)};
}

}  // namespace

SplatPlacer::SplatPlacer(const RenderOptions& options)
    : plane_(options.width, options.height, options.grid, options.stretch),
      pattern_(options.pattern),
      takes_negative_(!options.drops_negative) {
  if (pattern_ != SamplePattern::kFilter) return;
  const PixelFilterEntry* entry = FindPixelFilter(options.filter);
  CHECK(entry);
  filter_.emplace(*entry);
  radius_ = filter_->Radius();
}

float SplatPlacer::WeightAt(Vec2 offset) const {
  if (pattern_ == SamplePattern::kFilter) return filter_->At(offset);
  if (pattern_ != SamplePattern::kStrataTent) return 1;
  // The middle of a tent of radius 1, as wide as the pixel: its mean height along an axis is 3/4.
  return (1 - std::abs(offset.x)) * (1 - std::abs(offset.y)) * (16.0f / 9);
}

void SplatPlacer::Add(const Splat& splat, SplatFilm* film) const {
  // As for samples, before the weights of the filter, which may be negative.
  if (!takes_negative_ && splat.radiance.LeastComponent() < 0) {
    film->Drop();
    return;
  }
  const Vec2 position = plane_.PositionOf(splat.image_point);
  const PixelWindow& window = film->Window();
  const Pixels columns = PixelsAround(position.x, radius_, window.x0, window.x1);
  const Pixels rows = PixelsAround(position.y, radius_, window.y0, window.y1);
  const Rgb radiance = splat.radiance.ToRgb() * plane_.PixelsPerArea();
  for (int y = rows.begin; y < rows.end; ++y) {
    for (int x = columns.begin; x < columns.end; ++x) {
      const Vec2 offset{position.x - static_cast<float>(x), position.y - static_cast<float>(y)};
      const float weight = WeightAt(offset);
      if (weight != 0) film->Add(x, y, radiance * weight);
    }
  }
}

}  // namespace candela
