#pragma once

#include <algorithm>
#include <cmath>

namespace candela {

/// What a ray of a path stands for: a cone around it, whose width textures are averaged over:
/// Akenine-Möller et al., "Texture Level of Detail Strategies for Real-Time Ray Tracing", 2019. The
/// shorter axis of what the cone cuts out of a slanted surface is all that is averaged over; along
/// the longer one the samples of a pixel do it.
struct RayCone {
  float width = 0;   ///< Where the ray starts; 0 when it stands for itself alone.
  float spread = 0;  ///< How much wider it gets, per unit of length.

  void Travel(float distance) { width += spread * distance; }

  /// The ray is one of those that a surface might have sent out, drawn with the density `pdf` over
  /// solid angle. It stands for a sixteenth of its kind, since each pixel gets more than one.
  void Scatter(float pdf) {
    constexpr float kSpreadOfOne = 0.28209479f;  // 2 / sqrt(16 pi).
    constexpr float kWidest = 1;
    if (width > 0) spread = std::max(spread, std::min(kSpreadOfOne / std::sqrt(pdf), kWidest));
  }
};

}  // namespace candela
