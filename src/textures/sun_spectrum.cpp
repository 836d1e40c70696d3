#include "textures/sun_spectrum.h"

#include <algorithm>

#include "math/elementary.h"
#include "textures/cie_colour.h"

namespace candela {
namespace {

/// What the air and the sun are like at a wavelength. The gases that are mixed in the air take
/// light only beyond 750 nm.
struct Band {
  double sun;     ///< Radiance in W / (m^2 sr nm).
  double ozone;   ///< Absorption, 1 / cm,
  double vapour;  ///< and of water vapour.
};

constexpr double kFirst = 380, kStep = 10;  // In nanometres.

constexpr Band kBands[] = {
    {16559.0, 0.001, 0},     {16233.7, 0.001, 0},      {21127.5, 0.002, 0}, {25888.2, 0.002, 0},
    {25829.1, 0.002, 0},     {24232.3, 0.003, 0},      {26760.5, 0.003, 0}, {29658.3, 0.003, 0},
    {30545.4, 0.006, 0},     {30057.5, 0.009, 0},      {30663.7, 0.014, 0}, {28830.4, 0.021, 0},
    {28712.1, 0.030, 0},     {27825.0, 0.040, 0},      {27100.6, 0.048, 0}, {27233.6, 0.063, 0},
    {26361.3, 0.075, 0},     {25503.8, 0.085, 0},      {25060.2, 0.103, 0}, {25311.6, 0.120, 0},
    {25355.9, 0.120, 0},     {25134.2, 0.115, 0},      {24631.5, 0.125, 0}, {24173.2, 0.120, 0},
    {23685.3, 0.105, 0},     {23212.1, 0.090, 0},      {22827.7, 0.079, 0}, {22339.8, 0.067, 0},
    {21970.2, 0.057, 0},     {21526.7, 0.048, 0},      {21097.9, 0.036, 0}, {20728.3, 0.028, 0.016},
    {20240.4, 0.023, 0.024}, {19870.8, 0.018, 0.0125}, {19427.2, 0.014, 1}, {19072.4, 0.011, 0.87},
    {18628.9, 0.010, 0.061}, {18259.2, 0.009, 0.001},
};

/// The colour of the spectrum of which `left` passes of each band, over the disk of the sun.
template <class Left>
Rgb Irradiance(double angle_degrees, const Left& left) {
  constexpr double kLumensPerWatt = 683, kUnit = 1000;
  Vec3d xyz;
  double nanometres = kFirst;
  for (const Band& band : kBands) {
    xyz = xyz + ColourMatching(nanometres) * (band.sun * left(nanometres / 1000, band) * kStep);
    nanometres += kStep;
  }
  const double sine = SinDegrees(angle_degrees / 2);
  const double projected_solid_angle = kPi * sine * sine;
  return Max(RgbOfXyz(xyz * (kLumensPerWatt / kUnit * projected_solid_angle)), Rgb());
}

}  // namespace

Rgb SunIrradianceInSpace(double angle_degrees) {
  return Irradiance(angle_degrees, [](double, const Band&) { return 1.0; });
}

Rgb SunIrradianceThroughAir(double turbidity, double cos_zenith, double angle_degrees) {
  constexpr double kOzoneCentimetres = 0.35, kVapourCentimetres = 2;
  const double cosine = std::clamp(cos_zenith, 0.0, 1.0);
  const double degrees = Acos(cosine) * (180 / kPi);
  // How much more air there is on the way than above: Kasten 1966.
  const double air = 1 / (cosine + 0.15 * Pow(93.885 - degrees, -1.253));
  const double haze = 0.04608 * turbidity - 0.04586;
  return Irradiance(angle_degrees, [&](double micrometres, const Band& band) {
    const double molecules = 0.008735 * Pow(micrometres, -4.08);
    const double by_haze = haze * Pow(micrometres, -1.3);
    const double by_ozone = band.ozone * kOzoneCentimetres;
    const double vapour = band.vapour * kVapourCentimetres * air;
    const double by_vapour = 0.2385 * vapour / Pow(1 + 20.07 * vapour, 0.45);
    return Exp(-air * (molecules + by_haze + by_ozone) - by_vapour);
  });
}

}  // namespace candela
