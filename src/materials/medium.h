#pragma once

#include <span>
#include <string_view>
#include <tuple>

#include "materials/dispersion.h"
#include "math/spectrum.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// What fills a body that light can get into.
struct Medium {
  /// The refractive index for yellow light, over that of air; above 0.
  float ior = 1;
  /// What it takes of the light on its way, per unit of length: of radiance the part
  /// exp(-absorption * length) is left. Not negative.
  Rgb absorption{};
  Dispersion dispersion{};

  /// The refractive index for a wavelength in nanometres; 0 stands for all light.
  float IndexAt(float wavelength) const {
    return wavelength == 0 || dispersion.IsNone() ? ior : dispersion.At(wavelength);
  }

  /// Whether both have the same index for all light.
  bool RefractsAs(const Medium& other) const {
    if (ior != other.ior) return false;
    if (dispersion.IsNone() && other.dispersion.IsNone()) return true;
    return dispersion.Key() == other.dispersion.Key();
  }

  /// Media that have the same one are the same.
  auto Key() const {
    return std::tuple(ior, absorption.x, absorption.y, absorption.z, dispersion.Key());
  }

  /// Reads what it refracts by: `ior`, a number or the name of a substance, perhaps with `abbe`, or
  /// what `ReadDispersion` reads; and `absorption`.
  static Medium Create(ParamReader* params, float default_ior);

  /// The substances that have a name.
  static std::span<const NamedNumber> Substances();
};

inline const Medium kAir;

/// Reads a refractive index, over that of air: a number or the name of a substance.
float ReadRefractiveIndex(ParamReader* params, std::string_view name, float default_value);

}  // namespace candela
