#pragma once

#include <algorithm>

#include "math/vec.h"

namespace candela {

/// A linear colour: red, green, blue without a unit or range.
using Rgb = Vec3;

/// Radiance, intensity or reflectance as light transport carries it: four numbers, of which a
/// colour uses the first three. (A spectral mode would use all four as wavelengths.)
class Spectrum {
  /// One register: compilers take four numbers in an array through memory, which stalls.
  using Lanes [[gnu::vector_size(16)]] = float;

 public:
  constexpr Spectrum() = default;
  explicit constexpr Spectrum(float value) : lanes_{value, value, value, value} {}
  explicit constexpr Spectrum(Rgb rgb) : lanes_{rgb.x, rgb.y, rgb.z, 0} {}

  float operator[](int i) const { return lanes_[i]; }
  Rgb ToRgb() const { return {lanes_[0], lanes_[1], lanes_[2]}; }

  friend bool operator==(Spectrum a, Spectrum b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3];
  }
  friend Spectrum operator+(Spectrum a, Spectrum b) { return a += b; }
  friend Spectrum operator-(Spectrum a, Spectrum b) {
    a.lanes_ -= b.lanes_;
    return a;
  }
  friend Spectrum operator*(Spectrum a, Spectrum b) { return a *= b; }
  friend Spectrum operator/(Spectrum a, Spectrum b) {
    a.lanes_ /= b.lanes_;
    return a;
  }
  friend Spectrum operator*(Spectrum a, float s) { return a *= Spectrum(s); }
  friend Spectrum operator*(float s, Spectrum a) { return a *= Spectrum(s); }
  Spectrum& operator+=(Spectrum b) {
    lanes_ += b.lanes_;
    return *this;
  }
  Spectrum& operator*=(Spectrum b) {
    lanes_ *= b.lanes_;
    return *this;
  }

  bool IsBlack() const { return *this == Spectrum(); }
  float LeastComponent() const {
    return std::min(std::min(lanes_[0], lanes_[1]), std::min(lanes_[2], lanes_[3]));
  }
  float MaxComponent() const {
    return std::max(std::max(lanes_[0], lanes_[1]), std::max(lanes_[2], lanes_[3]));
  }

 private:
  Lanes lanes_{};
};

}  // namespace candela
