#pragma once

#include "math/spectrum.h"

namespace candela {

/// The temperatures, in kelvin, for which there is a colour.
inline constexpr float kLeastTemperature = 1000, kMostTemperature = 40000;

/// The linear colour of a black body, by Planck's law and the eye of the CIE's standard observer,
/// with the luminance 1. What a screen cannot show of the red of the coolest is cut off at 0.
Rgb BlackBodyColour(double kelvin);

}  // namespace candela
