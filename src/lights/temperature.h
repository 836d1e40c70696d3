#pragma once

#include "math/spectrum.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// What the parameter `temperature` multiplies the colour of a light by: the colour of a black body
/// of so many kelvin, of luminance 1. White when it is not given, or wrong, which is reported.
Rgb ReadTemperature(ParamReader* params);

}  // namespace candela
