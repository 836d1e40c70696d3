#pragma once

#include <array>
#include <cmath>

#include "math/vec.h"

namespace candela {

/// A linear colour: red, green, blue without a unit or range.
using Rgb = Vec3;

/// Radiance, intensity or reflectance as light transport carries it: four numbers, of which a
/// colour uses the first three. (A spectral mode would use all four as wavelengths.)
struct Spectrum {
  std::array<float, 4> c{};

  constexpr Spectrum() = default;
  explicit constexpr Spectrum(float value) : c{value, value, value, value} {}
  explicit constexpr Spectrum(Rgb rgb) : c{rgb.x, rgb.y, rgb.z, 0} {}

  constexpr float operator[](int i) const { return c[static_cast<size_t>(i)]; }
  constexpr Rgb ToRgb() const { return {c[0], c[1], c[2]}; }

  friend constexpr bool operator==(const Spectrum&, const Spectrum&) = default;
  friend constexpr Spectrum operator+(Spectrum a, const Spectrum& b) { return a += b; }
  friend constexpr Spectrum operator*(Spectrum a, const Spectrum& b) { return a *= b; }
  friend constexpr Spectrum operator*(Spectrum a, float s) { return a *= Spectrum(s); }
  friend constexpr Spectrum operator*(float s, Spectrum a) { return a *= Spectrum(s); }
  constexpr Spectrum& operator+=(const Spectrum& b) {
    for (size_t i = 0; i < 4; ++i) c[i] += b.c[i];
    return *this;
  }
  constexpr Spectrum& operator*=(const Spectrum& b) {
    for (size_t i = 0; i < 4; ++i) c[i] *= b.c[i];
    return *this;
  }

  constexpr bool IsBlack() const { return c[0] == 0 && c[1] == 0 && c[2] == 0 && c[3] == 0; }
  constexpr float LeastComponent() const {
    return std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
  }
  constexpr float MaxComponent() const {
    return std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
  }
};

}  // namespace candela
