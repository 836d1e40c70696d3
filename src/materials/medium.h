#pragma once

#include <span>
#include <string_view>

#include "math/spectrum.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// What fills a body that light can get into.
struct Medium {
  float ior = 1;  ///< The refractive index, over that of air; above 0.
  /// What it takes of the light on its way, per unit of length: of radiance the part
  /// exp(-absorption * length) is left. Not negative.
  Rgb absorption{};

  bool operator==(const Medium& other) const {
    return ior == other.ior && absorption == other.absorption;
  }

  /// Reads `ior`, a number or the name of a substance, and `absorption`.
  static Medium Create(ParamReader* params, float default_ior);

  /// The substances that have a name.
  static std::span<const NamedNumber> Substances();
};

/// Reads a refractive index, over that of air: a number or the name of a substance.
float ReadRefractiveIndex(ParamReader* params, std::string_view name, float default_value);

}  // namespace candela
