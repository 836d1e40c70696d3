#pragma once

#include "math/spectrum.h"

namespace candela {

/// The ends of what `SampleWavelength` draws, in nanometres.
inline constexpr float kShortestWavelength = 390, kLongestWavelength = 690;

/// How red, green and blue respond to light of a wavelength: each is a density per nanometre, so
/// its integral is 1.
Rgb ResponsesAt(float wavelength);

/// A wavelength in nanometres from a number in [0, 1): the mean of the responses is
/// its density.
float SampleWavelength(float u);

/// What light of one drawn wavelength counts in red, green and blue, where light of all would count
/// 1: the response of each over their mean. Not negative, and 1 in the mean, so that light which is
/// not split keeps its colour.
Spectrum ColourOf(float wavelength);

}  // namespace candela
