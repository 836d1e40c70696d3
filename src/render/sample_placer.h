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
/// options, pixel and sample.
class SamplePlacer {
 public:
  explicit SamplePlacer(const RenderOptions& options);

  struct Placed {
    SampleRequest request;
    float weight;
    float off_centre;  ///< The square of its distance from the middle of the pixel.
  };
  Placed Place(int x, int y, uint32_t index) const {
    const FilterSample position =
        pattern_ == SamplePattern::kCentre ? FilterSample() : PositionInPixel(x, y, index);
    return {{static_cast<uint32_t>(x), static_cast<uint32_t>(y), index,
             plane_.PointOf(x, y, position.offset), plane_.Spacing()},
            position.weight,
            position.offset.x * position.offset.x + position.offset.y * position.offset.y};
  }

  /// The sample in the middle of the pixel, whatever the pattern.
  SampleRequest Centre(int x, int y) const;

 private:
  FilterSample PositionInPixel(int x, int y, uint32_t index) const;

  ImagePlane plane_;
  SamplePattern pattern_;
  uint32_t seed_;
  SamplerType sampler_;
  std::optional<PixelFilter> filter_;
};

}  // namespace candela
