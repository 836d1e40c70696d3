#include "materials/medium.h"

namespace candela {
namespace {

// For yellow light, from Hecht, "Optics".
constexpr NamedNumber kSubstances[] = {
    {"ice", 1.31f},         {"water", 1.333f},   {"ethanol", 1.36f},
    {"quartz", 1.458f},     {"glass", 1.5f},     {"acrylic", 1.49f},
    {"flint_glass", 1.66f}, {"sapphire", 1.77f}, {"diamond", 2.417f}};

}  // namespace

Medium Medium::Create(ParamReader* params, float default_ior) {
  Medium medium;
  medium.ior = ReadRefractiveIndex(params, "ior", default_ior);
  medium.absorption = params->NonNegativeColor("absorption", {0, 0, 0});
  return medium;
}

std::span<const NamedNumber> Medium::Substances() {
  return kSubstances;
}

float ReadRefractiveIndex(ParamReader* params, std::string_view name, float default_value) {
  return params->PositiveOrNamed(name, kSubstances, default_value);
}

}  // namespace candela
