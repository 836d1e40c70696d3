#include "lights/temperature.h"

#include <fmt/format.h>

#include "textures/black_body.h"

namespace candela {

Rgb ByTemperature(ParamReader* params, Rgb color) {
  if (!params->Has("temperature")) return color;
  const float kelvin = params->Number("temperature", kLeastTemperature);
  if (!(kelvin >= kLeastTemperature && kelvin <= kMostTemperature)) {
    params->Error(params->Where("temperature"),
                  fmt::format("'temperature' expects a number of kelvin from {} to {}, found '{}'",
                              kLeastTemperature, kMostTemperature, kelvin));
    return color;
  }
  const Rgb tinted = color * BlackBodyColour(kelvin);
  if (IsFinite(tinted)) return tinted;
  params->Error(params->Where("temperature"),
                "'temperature' makes a colour this large too large for numbers");
  return color;
}

}  // namespace candela
