#include "lights/temperature.h"

#include <fmt/format.h>

#include "textures/black_body.h"

namespace candela {

Rgb ReadTemperature(ParamReader* params) {
  constexpr Rgb kWhite{1, 1, 1};
  if (!params->Has("temperature")) return kWhite;
  const float kelvin = params->Number("temperature", kLeastTemperature);
  if (kelvin >= kLeastTemperature && kelvin <= kMostTemperature) return BlackBodyColour(kelvin);
  params->Error(params->Where("temperature"),
                fmt::format("'temperature' expects a number of kelvin from {} to {}, found '{}'",
                            kLeastTemperature, kMostTemperature, kelvin));
  return kWhite;
}

}  // namespace candela
