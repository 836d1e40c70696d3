#include "textures/daylight.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "textures/cie_colour.h"
#include "textures/sun_spectrum.h"

namespace candela {
namespace {

/// A polynomial of third degree in the angle of the sun to the zenith.
double Cubic(double c3, double c2, double c1, double c0, double x) {
  return ((c3 * x + c2) * x + c1) * x + c0;
}

/// Not by the cosine, which has no digits left near the sun.
double AngleBetween(Vec3d a, Vec3d b) {
  return Atan2(Length(Cross(a, b)), Dot(a, b));
}

}  // namespace

double Daylight::Distribution::At(double cos_zenith, double angle_to_sun) const {
  const double gradation = 1 + a * (cos_zenith > 0 ? Exp(b / cos_zenith) : 0.0);
  const double cosine = Cos(angle_to_sun);
  const double around_sun = 1 + c * Exp(d * angle_to_sun) + e * cosine * cosine;
  return zenith * gradation * around_sun;
}

// The numbers are those of the appendix of the paper.
Daylight::Daylight(float turbidity, Vec3 to_sun)
    : to_sun_(ToDouble(to_sun)),
      sun_irradiance_(
          SunIrradianceThroughAir(double{turbidity}, double{to_sun.y}, double{kSunAngleDegrees})) {
  const double t = double{turbidity};
  const double sun = AngleBetween(to_sun_, {0, 1, 0});
  luminance_ = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                0.1206 * t - 2.5771, -0.0670 * t + 0.3703, 1};
  x_ = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
        -0.0641 * t - 0.8989, -0.0033 * t + 0.0452, 1};
  y_ = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
        -0.0441 * t - 1.6537, -0.0109 * t + 0.0529, 1};

  const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * sun);
  const double luminance = (4.0453 * t - 4.9710) * Tan(chi) - 0.2155 * t + 2.4192;
  const double x = Cubic(0.00166, -0.00375, 0.00209, 0, sun) * t * t +
                   Cubic(-0.02903, 0.06377, -0.03202, 0.00394, sun) * t +
                   Cubic(0.11693, -0.21196, 0.06052, 0.25886, sun);
  const double y = Cubic(0.00275, -0.00610, 0.00317, 0, sun) * t * t +
                   Cubic(-0.04214, 0.08970, -0.04153, 0.00516, sun) * t +
                   Cubic(0.15346, -0.26756, 0.06670, 0.26688, sun);
  luminance_.zenith = luminance / luminance_.At(1, sun);
  x_.zenith = x / x_.At(1, sun);
  y_.zenith = y / y_.At(1, sun);
}

Daylight::Chromatic Daylight::SkyColour(Vec3 direction) const {
  const Vec3d w = ToDouble(direction);
  const double angle = AngleBetween(w, to_sun_);
  return {luminance_.At(w.y, angle), x_.At(w.y, angle), y_.At(w.y, angle)};
}

Rgb Daylight::SkyRadiance(Vec3 direction) const {
  if (direction.y < 0) {
    const Vec3 level{direction.x, 0, direction.z};
    direction = level == Vec3() ? Vec3{1, 0, 0} : Normalize(level);
  }
  const Chromatic colour = SkyColour(direction);
  const double sum = colour.luminance / colour.y;  // X + Y + Z.
  const Rgb rgb = RgbOfXyz({colour.x * sum, colour.luminance, (1 - colour.x - colour.y) * sum});
  return Max(rgb, Rgb());
}

}  // namespace candela
