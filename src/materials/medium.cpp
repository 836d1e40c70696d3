#include "materials/medium.h"

#include <fmt/format.h>

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
  if (const auto dispersion = ReadDispersion(params)) {
    medium.dispersion = *dispersion;
    if (!dispersion->IsNone()) medium.ior = dispersion->At(Dispersion::kYellow);
    for (const char* name : {"ior", "abbe"}) {
      if (!params->Has(name)) continue;
      params->Error(params->Where(name),
                    fmt::format("'{}' has no effect: 'cauchy' and 'sellmeier_b' say how light is "
                                "refracted",
                                name));
    }
  } else {
    medium.ior = ReadRefractiveIndex(params, "ior", default_ior);
    medium.dispersion = ReadAbbeNumber(params, medium.ior);
  }
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
