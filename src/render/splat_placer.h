#pragma once

#include <optional>

#include "cameras/image_plane.h"
#include "film/pixel_filter.h"
#include "film/splat_film.h"
#include "integrators/integrator.h"
#include "render/render_options.h"

namespace candela {

/// Gives splats to the pixels that they count for, weighed as the samples of the camera are: by the
/// pixel filter, of which that of the patterns without one is the box.
class SplatPlacer {
 public:
  explicit SplatPlacer(const RenderOptions& options);

  /// Pixels outside of the film get nothing. A splat that `RenderOptions::drops_negative` leaves
  /// out is counted by the film as dropped. May be called concurrently.
  void Add(const Splat& splat, SplatFilm* film) const;

 private:
  float WeightAt(Vec2 offset) const;

  ImagePlane plane_;
  SamplePattern pattern_;
  bool takes_negative_;
  std::optional<PixelFilter> filter_;
  float radius_ = 0.5f;
};

}  // namespace candela
