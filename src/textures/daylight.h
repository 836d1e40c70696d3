#pragma once

#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

/// The light of a clear sky and of the sun in it: A. J. Preetham, P. Shirley, B. Smits, "A
/// Practical Analytic Model for Daylight", 1999. Its fit is for turbidities of 2 to 6; above it
/// goes on smoothly to 10. Colours are linear, of the primaries of sRGB; 1 is a luminance of 1000
/// cd / m^2, or 1.464 W / (m^2 sr) of light of 555 nm.
class Daylight {
 public:
  /// Of the disk of the sun, from one rim to the other, on the average of a year.
  static constexpr float kSunAngleDegrees = 0.533f;

  /// `turbidity`, from 2 to 10, says how hazy the air is: how much thicker than pure air. The
  /// unit vector `to_sun` points to the sun, which is not below the horizon (y is 0 or more).
  Daylight(float turbidity, Vec3 to_sun);

  /// The radiance of the sky from a unit direction; below the horizon that of the horizon. Without
  /// the sun. A colour that no screen shows is cut off at 0.
  Rgb SkyRadiance(Vec3 direction) const;
  /// Its luminance in 1000 cd / m^2, and its chromaticities, after the paper.
  struct Chromatic {
    double luminance, x, y;
  };
  Chromatic SkyColour(Vec3 direction) const;

  /// The irradiance that the whole disk of the sun gives at normal incidence, after its way through
  /// the air.
  Rgb SunIrradiance() const { return sun_irradiance_; }

 private:
  /// How a quantity goes over the sky: Perez, Seals, Michalsky, "All-weather model for sky
  /// luminance distribution", 1993.
  struct Distribution {
    double a, b, c, d, e;
    double zenith;  ///< The quantity there, over the value that the formula has there.

    double At(double cos_zenith, double angle_to_sun) const;
  };

  Vec3d to_sun_;
  Distribution luminance_, x_, y_;
  Rgb sun_irradiance_;
};

}  // namespace candela
