#pragma once

#include <cstdint>
#include <optional>

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

  struct Place {
    float weight;
    float off_centre;  ///< The square of its distance from the middle of the pixel.
  };
  /// Makes the request for a sample. Series 1 has random numbers that know nothing of those of
  /// series 0: they are those of a pixel that no picture has.
  Place Request(int x, int y, uint32_t index, uint32_t series, SampleRequest* request) const {
    const uint32_t row = static_cast<uint32_t>(y) | series << kSeriesBit;
    const FilterSample position =
        pattern_ == SamplePattern::kCentre ? FilterSample() : PositionInPixel(x, row, index);
    request->x = static_cast<uint32_t>(x);
    request->y = row;
    request->index = index;
    request->image_point = plane_.PointOf(x, y, position.offset);
    request->spacing = plane_.Spacing();
    return {position.weight,
            position.offset.x * position.offset.x + position.offset.y * position.offset.y};
  }

  /// The row of the picture to which a sample belongs, of whatever series.
  static int RowOf(const SampleRequest& request) {
    return static_cast<int>(request.y & ~(uint32_t{1} << kSeriesBit));
  }

  /// The sample in the middle of the pixel, whatever the pattern.
  SampleRequest Centre(int x, int y) const;

 private:
  static constexpr uint32_t kSeriesBit = 31;

  FilterSample PositionInPixel(int x, uint32_t row, uint32_t index) const;

  ImagePlane plane_;
  SamplePattern pattern_;
  uint32_t seed_;
  SamplerType sampler_;
  std::optional<PixelFilter> filter_;
};

}  // namespace candela
