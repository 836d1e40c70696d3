#pragma once

#include "math/spectrum.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A colour by the parameter `temperature`: multiplied by that of a black body of so many kelvin,
/// of luminance 1. As it is when the parameter is not given, or wrong, which is reported.
Rgb ByTemperature(ParamReader* params, Rgb color);

}  // namespace candela
