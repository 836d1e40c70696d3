#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "cameras/image_plane.h"
#include "film/pixel_filter.h"
#include "integrators/integrator.h"
#include "render/render_options.h"
#include "sampling/sampler.h"

namespace candela {

/// Chooses where in a pixel each of its samples lies and what it counts. A pure function of
/// options, pixel, sample and series.
class SamplePlacer {
 public:
  explicit SamplePlacer(const RenderOptions& options);

  /// The request for a sample that has no place in its pixel yet. Series 1 has random numbers that
  /// know nothing of those of series 0: they are those of a pixel that no picture has.
  static SampleRequest Request(int x, int y, uint32_t index, uint32_t series) {
    return {static_cast<uint32_t>(x), static_cast<uint32_t>(y) | series << kSeriesBit, index};
  }

  /// Gives each of the samples its place: entry i of each list belongs to the same sample. Offsets
  /// are from the middle of the pixel, in pixels.
  void Place(std::span<SampleRequest> requests, std::span<FilterSample> places) const;

  /// The row of the picture to which a sample belongs, of whatever series.
  static int RowOf(const SampleRequest& request) {
    return static_cast<int>(request.y & ~(uint32_t{1} << kSeriesBit));
  }

  /// The sample in the middle of the pixel, whatever the pattern.
  SampleRequest Centre(int x, int y) const;

 private:
  static constexpr uint32_t kSeriesBit = 31;

  FilterSample PositionInPixel(uint32_t index, Vec2 u) const;

  ImagePlane plane_;
  SamplePattern pattern_;
  uint32_t seed_;
  SamplerType sampler_;
  std::optional<PixelFilter> filter_;
};

}  // namespace candela
