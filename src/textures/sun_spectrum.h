#pragma once

#include "math/spectrum.h"

namespace candela {

/// The irradiance of the sun at normal incidence in the unit of `Daylight`, by its spectrum from
/// 380 to 750 nm: outside of the air, seen under a full angle in degrees.
Rgb SunIrradianceInSpace(double angle_degrees);

/// The same after its way through air of a turbidity of at least 1, for the cosine of its angle to
/// the zenith, 0 or more: what molecules, haze, ozone and water vapour leave of each wavelength
/// (Preetham, Shirley, Smits 1999, appendix, after M. Iqbal, "An Introduction to Solar Radiation",
/// 1983). Colours that no screen shows are cut off at 0.
Rgb SunIrradianceThroughAir(double turbidity, double cos_zenith, double angle_degrees);

}  // namespace candela
