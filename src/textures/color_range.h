#pragma once

#include "textures/texture_input.h"

namespace candela {

/// What a texture that computes a number from 0 to 1 makes of it: a colour between two.
class ColorRange {
 public:
  /// Reads `low` and `high`.
  static ColorRange Create(ParamReader* params, const TextureContext& context) {
    ColorRange range;
    range.low_ = ColorInput::Color(params, "low", {0, 0, 0}, context);
    range.high_ = ColorInput::Color(params, "high", {1, 1, 1}, context);
    return range;
  }

  Rgb At(float t, const SurfacePoint& point) const {
    return low_.At(point) * (1 - t) + high_.At(point) * t;
  }

 private:
  ColorInput low_, high_;
};

}  // namespace candela
