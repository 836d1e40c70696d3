#include "render/sample_placer.h"

#include <cmath>

#include "base/check.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

/// Height of the tent of radius 1 along one axis.
float Tent(float offset) {
  return 1 - std::abs(offset);
}

}  // namespace

SamplePlacer::SamplePlacer(const RenderOptions& options)
    : plane_(options.width, options.height, options.grid, options.stretch),
      pattern_(options.pattern),
      seed_(options.seed),
      sampler_(options.sampler) {
  if (pattern_ != SamplePattern::kFilter) return;
  const PixelFilterEntry* entry = FindPixelFilter(options.filter);
  CHECK(entry);
  filter_.emplace(*entry);
}

FilterSample SamplePlacer::PositionInPixel(int x, uint32_t row, uint32_t index) const {
  const Sampler sampler(seed_, static_cast<uint32_t>(x), row, index, sampler_);
  const Vec2 u = sampler.Get2D(kFilmDimension);
  if (pattern_ == SamplePattern::kFilter) return filter_->Sample(u);

  const Vec2 stratum{static_cast<float>(index % kStrataPerSide),
                     static_cast<float>(index / kStrataPerSide)};
  const Vec2 offset = (stratum + u) * (1.0f / kStrataPerSide) - Vec2{0.5f, 0.5f};
  const bool is_tent = pattern_ == SamplePattern::kStrataTent;
  return {offset, is_tent ? Tent(offset.x) * Tent(offset.y) : 1};
}

SampleRequest SamplePlacer::Centre(int x, int y) const {
  return {static_cast<uint32_t>(x), static_cast<uint32_t>(y), 0, plane_.PointOf(x, y, {}),
          plane_.Spacing()};
}

}  // namespace candela
