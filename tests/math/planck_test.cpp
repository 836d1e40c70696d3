#include "math/planck.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

// CF36
TEST(Planck, OfTheSunsTemperatureHasTheClosedForm) {
  EXPECT_NEAR(PlanckRadiance(500e-9, 5778), 2.63757e13, 0.000005e13);  // All its digits.
}

/// Where it is greatest, in metres.
double Peak(double kelvin) {
  double low = 1e-7, high = 1e-5;
  while (high - low > 1e-12) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (PlanckRadiance(a, kelvin) < PlanckRadiance(b, kelvin)) {
      low = a;
    } else {
      high = b;
    }
  }
  return (low + high) / 2;
}

// CF36: Wien's law.
TEST(Planck, PeaksWhereWienSays) {
  EXPECT_NEAR(Peak(5778) * 1e9, 501.518, 0.002);
  EXPECT_NEAR(Peak(1000) * 1e9, 2897.772, 0.02);
}

// CF36: over all wavelengths and directions it is the law of Stefan and Boltzmann.
TEST(Planck, SumsToTheFourthPowerOfTheTemperature) {
  constexpr double kStefanBoltzmann = 5.670374419e-8;
  for (const double kelvin : {1000., 5778.}) {
    double sum = 0;
    // Evenly in the logarithm of the wavelength, from 30 nm to 30 mm at 1000 K.
    constexpr int kSteps = 2000;
    const double step = Log(1e6) / kSteps;
    const double ratio = Exp(step);
    double wavelength = 30e-6 / kelvin * std::sqrt(ratio);
    for (int i = 0; i < kSteps; ++i, wavelength *= ratio) {
      sum += PlanckRadiance(wavelength, kelvin) * wavelength * step;
    }
    const double expected = kStefanBoltzmann * kelvin * kelvin * kelvin * kelvin;
    EXPECT_NEAR(kPi * sum / expected, 1, 1e-4) << kelvin;
  }
}

}  // namespace
}  // namespace candela
