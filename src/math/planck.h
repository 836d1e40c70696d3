#pragma once

namespace candela {

/// The radiance of a black body per length of wavelength, in W / (m^2 sr) per metre: M. Planck,
/// "On the Law of Distribution of Energy in the Normal Spectrum", 1901, with the constants of the
/// SI of 2019. `wavelength` is in metres, from 1e-9 on; `kelvin` is above 0.
double PlanckRadiance(double wavelength, double kelvin);

}  // namespace candela
