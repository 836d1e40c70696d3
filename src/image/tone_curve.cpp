#include "image/tone_curve.h"

#include <algorithm>

#include "math/elementary.h"

namespace candela {
namespace {

float Clamp(float x) {
  return std::clamp(x, 0.0f, 1.0f);
}

template <class Function>
Rgb Each(Rgb c, Function function) {
  return {function(c.x), function(c.y), function(c.z)};
}

Rgb EncodeNone(Rgb linear) {
  return Each(linear, Clamp);
}

Rgb EncodeSrgb(Rgb linear) {
  return Each(linear, [](float x) { return SrgbFromLinear(Clamp(x)); });
}

/// A rational curve with a toe and a shoulder, in the shape of film: J. Hable, "Filmic Tonemapping
/// Operators", 2010. Linear 11.2 and more, after his doubling, is white.
float Hable(float x) {
  constexpr float kShoulder = 0.15f, kLinear = 0.5f, kAngle = 0.1f, kToe = 0.2f;
  constexpr float kToeNumerator = 0.02f, kToeDenominator = 0.3f;
  return (x * (kShoulder * x + kAngle * kLinear) + kToe * kToeNumerator) /
             (x * (kShoulder * x + kLinear) + kToe * kToeDenominator) -
         kToeNumerator / kToeDenominator;
}

Rgb EncodeFilmic(Rgb linear) {
  static constexpr float kExposure = 2, kWhite = 11.2f;
  return Each(linear, [white = Hable(kWhite)](float x) {
    return SrgbFromLinear(Clamp(Hable(std::min(x * kExposure, kWhite)) / white));
  });
}

/// The rows of a matrix times a colour.
Rgb Times(const float (&m)[3][3], Rgb c) {
  const auto row = [&](int i) { return m[i][0] * c.x + m[i][1] * c.y + m[i][2] * c.z; };
  return {row(0), row(1), row(2)};
}

/// The contrast of AgX over its range of 16.5 stops, as a polynomial.
float AgxContrast(float x) {
  return ((((((15.5f * x - 40.14f) * x + 31.96f) * x - 6.868f) * x + 0.4298f) * x + 0.1191f) * x -
          0.00232f);
}

/// Colours move towards grey, then the logarithm of each goes along a curve, so that bright colours
/// turn white without changing their hue: T. Sobotka, "AgX", 2022, with the fit of B. Wrensch,
/// "Minimal AgX Implementation", 2023.
Rgb EncodeAgx(Rgb linear) {
  static constexpr float kInset[3][3] = {{0.842479062f, 0.0784336f, 0.0792237452f},
                                         {0.0423282423f, 0.878468636f, 0.0791661275f},
                                         {0.0423756549f, 0.0784336f, 0.879142974f}};
  static constexpr float kOutset[3][3] = {{1.196879005f, -0.0980208811f, -0.0990297441f},
                                          {-0.0528968518f, 1.15190313f, -0.0989611768f},
                                          {-0.0529716355f, -0.0980434501f, 1.151073673f}};
  constexpr float kLeast = -12.47393f, kMost = 4.026069f;  // Stops around 1.
  const Rgb encoded = Each(Times(kInset, linear), [](float x) {
    const float stops = Log2(std::max(x, 1e-10f));
    return AgxContrast(Clamp((stops - kLeast) / (kMost - kLeast)));
  });
  return Each(Times(kOutset, encoded), Clamp);
}

constexpr ToneCurve kCurves[] = {
    {"none", "cuts off at 0 and 1", EncodeNone},
    {"srgb", "cuts off, then encodes for displays", EncodeSrgb},
    {"filmic", "soft shadows and highlights (Hable)", EncodeFilmic},
    {"agx", "soft highlights of any colour (AgX)", EncodeAgx},
};

}  // namespace

std::span<const ToneCurve> ToneCurves() {
  return kCurves;
}

const ToneCurve* FindToneCurve(std::string_view name) {
  const auto found = std::ranges::find(kCurves, name, &ToneCurve::name);
  return found == std::end(kCurves) ? nullptr : found;
}

Rgb ToneMapping::Encode(Rgb linear) const {
  static constexpr float kBrightest = 1e30f;
  const auto usable = [this](float x) { return x > 0 ? std::min(x * gain, kBrightest) : 0.0f; };
  const Rgb scaled = Each(linear, usable);
  return curve ? curve->encode(scaled) : scaled;
}

float SrgbFromLinear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * Pow(linear, 1 / 2.4f) - 0.055f;
}

float LinearFromSrgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : Pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace candela
