#pragma once

#include <string_view>

#include "scene_spec/param_reader.h"

namespace candela {

/// Reads a refractive index, over that of air: a number or the name of a substance. The values are
/// those for yellow light, from Hecht, "Optics".
inline float ReadRefractiveIndex(ParamReader* params, std::string_view name, float default_value) {
  static constexpr NamedNumber kSubstances[] = {
      {"ice", 1.31f},         {"water", 1.333f},   {"ethanol", 1.36f},
      {"quartz", 1.458f},     {"glass", 1.5f},     {"acrylic", 1.49f},
      {"flint_glass", 1.66f}, {"sapphire", 1.77f}, {"diamond", 2.417f}};
  return params->PositiveOrNamed(name, kSubstances, default_value);
}

}  // namespace candela
