#include "render/sample_placer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "sampling/sampler.h"
#include "sampling/sobol_block.h"

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

void SamplePlacer::Place(std::span<SampleRequest> requests, std::span<FilterSample> places) const {
  constexpr size_t kTogether = sobol::Block::kSize;  // So that blocks are full.
  std::array<Sampler, kTogether> samplers;
  std::array<Vec2, kTogether> u;
  for (size_t begin = 0; begin < requests.size(); begin += kTogether) {
    const size_t count = std::min(kTogether, requests.size() - begin);
    if (pattern_ != SamplePattern::kCentre) {
      for (size_t i = 0; i < count; ++i) {
        const SampleRequest& request = requests[begin + i];
        samplers[i] = Sampler(seed_, request.x, request.y, request.index, sampler_);
      }
      Sampler::Get2D({samplers.data(), count}, kFilmDimension, {u.data(), count});
    }
    for (size_t i = 0; i < count; ++i) {
      SampleRequest& request = requests[begin + i];
      FilterSample& place = places[begin + i];
      place = pattern_ == SamplePattern::kCentre ? FilterSample()
                                                 : PositionInPixel(request.index, u[i]);
      request.image_point =
          plane_.PointOf(static_cast<int>(request.x), RowOf(request), place.offset);
      request.spacing = plane_.Spacing();
    }
  }
}

FilterSample SamplePlacer::PositionInPixel(uint32_t index, Vec2 u) const {
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
