#pragma once

#include "math/exact_sum.h"
#include "math/spectrum.h"

namespace candela {

/// Everything a pixel has to remember of its colour to be continued: exact, so that no order of
/// samples shows.
struct PixelSums {
  ExactSum red, green, blue, weight;

  void Add(Rgb radiance, float sample_weight);
  /// The weighted mean. Black while the weights sum to 0, which they do before the first sample.
  Vec3d PreciseMean() const;
  Rgb Mean() const { return ToFloat(PreciseMean()); }

  friend bool operator==(const PixelSums&, const PixelSums&) = default;
};

}  // namespace candela
