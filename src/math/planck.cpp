#include "math/planck.h"

#include "math/elementary.h"

namespace candela {

double PlanckRadiance(double wavelength, double kelvin) {
  constexpr double kPlanck = 6.62607015e-34;     // In J s.
  constexpr double kBoltzmann = 1.380649e-23;    // In J / K.
  constexpr double kSpeedOfLight = 299792458.0;  // In m / s.
  const double squared = wavelength * wavelength;
  const double quanta = kPlanck * kSpeedOfLight / (wavelength * kBoltzmann * kelvin);
  return 2 * kPlanck * kSpeedOfLight * kSpeedOfLight / (squared * squared * wavelength) /
         (Exp(quanta) - 1);
}

}  // namespace candela
