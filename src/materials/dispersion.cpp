#include "materials/dispersion.h"

#include <fmt/format.h>

#include <cmath>

#include "math/wavelength.h"

namespace candela {
namespace {

// The F and C lines of hydrogen, between which Abbe numbers are measured, in nanometres.
constexpr double kBlue = 486.1327, kRed = 656.2725;

constexpr double InverseSquare(double wavelength) {
  const double micrometres = wavelength / 1000;
  return 1 / (micrometres * micrometres);
}

/// Between the ends of visible light the curves have no poles in use, so a few places tell.
bool IsLegal(const Dispersion& dispersion) {
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    const float share = static_cast<float>(i) / kSteps;
    const float index =
        dispersion.At(kShortestWavelength + (kLongestWavelength - kShortestWavelength) * share);
    if (!(index > 0) || !std::isfinite(index)) return false;
  }
  return true;
}

Dispersion Legal(const Dispersion& dispersion, std::string_view name, ParamReader* params) {
  if (IsLegal(dispersion)) return dispersion;
  params->Error(params->Where(name),
                fmt::format("'{}' gives no refractive index above 0 for all light from {} to {} nm",
                            name, kShortestWavelength, kLongestWavelength));
  return {};
}

}  // namespace

Dispersion Dispersion::Cauchy(Vec3 abc) {
  return {Kind::kCauchy, abc, {}};
}

Dispersion Dispersion::Sellmeier(Vec3 b, Vec3 c) {
  return {Kind::kSellmeier, b, c};
}

Dispersion Dispersion::OfAbbeNumber(float ior, float abbe) {
  const double spread = (double{ior} - 1) / double{abbe};
  const double b = spread / (InverseSquare(kBlue) - InverseSquare(kRed));
  const double a = double{ior} - b * InverseSquare(double{kYellow});
  return Cauchy({static_cast<float>(a), static_cast<float>(b), 0});
}

float Dispersion::At(float wavelength) const {
  const float micrometres = wavelength / 1000;
  const float square = micrometres * micrometres;
  if (kind_ == Kind::kCauchy) return terms_[0] + (terms_[1] + terms_[2] / square) / square;
  float index_squared = 1;
  for (size_t i = 0; i < 3; ++i) index_squared += terms_[i] * square / (square - terms_[i + 3]);
  return std::sqrt(index_squared);
}

Dispersion ReadAbbeNumber(ParamReader* params, float ior) {
  if (!params->Has("abbe")) return {};
  return Legal(Dispersion::OfAbbeNumber(ior, params->Positive("abbe", 1)), "abbe", params);
}

std::optional<Dispersion> ReadDispersion(ParamReader* params) {
  const bool has_b = params->Has("sellmeier_b"), has_c = params->Has("sellmeier_c");
  if (params->Has("cauchy")) {
    if (has_b || has_c) {
      params->Error(params->Where("cauchy"), "'cauchy' and 'sellmeier_b' exclude each other");
    }
    return Legal(Dispersion::Cauchy(params->Vector("cauchy", {1, 0, 0})), "cauchy", params);
  }
  if (!has_b && !has_c) return std::nullopt;
  const Vec3 b = params->RequiredVector("sellmeier_b"), c = params->RequiredVector("sellmeier_c");
  if (!has_b || !has_c) return Dispersion();
  return Legal(Dispersion::Sellmeier(b, c), "sellmeier_b", params);
}

}  // namespace candela
