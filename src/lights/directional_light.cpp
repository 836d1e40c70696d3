#include "lights/directional_light.h"

namespace candela {

std::unique_ptr<Light> DirectionalLight::Create(ParamReader* params, const LightContext&) {
  const Vec3 direction = params->RequiredDirection("direction");
  const Rgb color = params->Color("color", {1, 1, 1});
  params->Positive("attenuation", 20);  // The course's format allows it here, without effect.
  return std::make_unique<DirectionalLight>(direction, color);
}

}  // namespace candela
