#pragma once

#include <span>
#include <string_view>

#include "math/spectrum.h"

namespace candela {

/// A way to show light of any strength on a display.
struct ToneCurve {
  std::string_view name;
  std::string_view description;
  /// Display values from 0 to 1 for linear values of at least 0; encoded for an sRGB display, but
  /// for `none`. Each of them grows with the brightness of a grey.
  Rgb (*encode)(Rgb linear);
};

/// All curves, in the order of the manual.
std::span<const ToneCurve> ToneCurves();

/// The curve of that name, or null.
const ToneCurve* FindToneCurve(std::string_view name);

/// A curve, and how bright the light is before it.
struct ToneMapping {
  const ToneCurve* curve = nullptr;  ///< Null: the values as they are.
  float gain = 1;

  /// NaN and negative components count as 0; infinite ones are the brightest.
  Rgb Encode(Rgb linear) const;
};

/// The encoding of a linear value from 0 to 1 for an sRGB display, and back: IEC 61966-2-1, 1999.
float SrgbFromLinear(float linear);
float LinearFromSrgb(float encoded);

}  // namespace candela
