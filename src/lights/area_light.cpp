#include "lights/area_light.h"

#include <algorithm>

#include "lights/light_context.h"

namespace candela {

std::unique_ptr<Light> AreaLight::Create(ParamReader* params, const LightContext& context) {
  const Rgb radiance = params->NonNegativeColor("radiance", {1, 1, 1});
  if (!context.has_object) {
    params->Error(params->Where("type"),
                  "an area light needs an object in its node, to shine from");
  }
  return std::make_unique<AreaLight>(Spectrum(radiance));
}

}  // namespace candela
