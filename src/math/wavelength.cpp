#include "math/wavelength.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

/// A tent over wavelengths, of area 1: displays and eyes respond to more than that, but partly by
/// less than nothing, which light cannot be weighted with.
struct Response {
  float middle, reach;

  float At(float wavelength) const {
    return std::max(0.0f, 1 - std::abs(wavelength - middle) / reach) / reach;
  }
  /// By the inverse of its cumulative distribution.
  float Sample(float u) const {
    return u < 0.5f ? middle - reach * (1 - std::sqrt(2 * u))
                    : middle + reach * (1 - std::sqrt(2 * (1 - u)));
  }
};

constexpr Response kRed{620, 70}, kGreen{540, 70}, kBlue{455, 65};

}  // namespace

Rgb ResponsesAt(float wavelength) {
  return {kRed.At(wavelength), kGreen.At(wavelength), kBlue.At(wavelength)};
}

float SampleWavelength(float u) {
  const float third = 3 * u;
  const Response& response = third < 1 ? kBlue : third < 2 ? kGreen : kRed;
  const float left = third < 1 ? third : third < 2 ? third - 1 : third - 2;
  return response.Sample(std::min(left, 1.0f));
}

Spectrum ColourOf(float wavelength) {
  const Rgb responses = ResponsesAt(wavelength);
  const float mean = (responses.x + responses.y + responses.z) / 3;
  return mean > 0 ? Spectrum(responses / mean) : Spectrum();
}

}  // namespace candela
