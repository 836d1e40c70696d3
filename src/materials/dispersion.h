#pragma once

#include <array>
#include <optional>

#include "scene_spec/param_reader.h"

namespace candela {

/// How the refractive index of a medium depends on the wavelength of light in air: by nothing, by
/// Cauchy's or by Sellmeier's equation. For glass both hold for visible light.
class Dispersion {
 public:
  /// Of yellow light, where `ior` is measured: the d line of helium, in nanometres.
  static constexpr float kYellow = 587.5618f;

  /// None.
  Dispersion() = default;
  /// n = a + b / l^2 + c / l^4, where l is the wavelength in micrometres.
  static Dispersion Cauchy(Vec3 abc);
  /// n^2 = 1 + the sum of b_i l^2 / (l^2 - c_i), with c in square micrometres.
  static Dispersion Sellmeier(Vec3 b, Vec3 c);
  /// Cauchy's equation with two terms, from the index of yellow light and the Abbe number
  /// V = (n_d - 1) / (n_F - n_C), above 0.
  static Dispersion OfAbbeNumber(float ior, float abbe);

  bool IsNone() const { return kind_ == Kind::kNone; }
  /// The refractive index for a wavelength in nanometres; not for none.
  float At(float wavelength) const;

  /// The numbers that say which one it is.
  auto Key() const { return std::pair(kind_, terms_); }

 private:
  enum class Kind { kNone, kCauchy, kSellmeier };

  Dispersion(Kind kind, Vec3 first, Vec3 second)
      : kind_(kind), terms_{first.x, first.y, first.z, second.x, second.y, second.z} {}

  Kind kind_ = Kind::kNone;
  std::array<float, 6> terms_{};
};

/// Reads `abbe` for a medium whose index for yellow light is known; without it there is none.
Dispersion ReadAbbeNumber(ParamReader* params, float ior);

/// Reads `cauchy`, or `sellmeier_b` and `sellmeier_c`; nothing when neither is given. Both report
/// what gives no refractive index above 0 for all visible light.
std::optional<Dispersion> ReadDispersion(ParamReader* params);

}  // namespace candela
