#include "lights/registry.h"

#include "lights/area_light.h"
#include "lights/directional_light.h"
#include "lights/ies_light.h"
#include "lights/point_light.h"
#include "lights/projector_light.h"
#include "lights/spot_light.h"
#include "scene_spec/light_group.h"
#include "scene_spec/registry.h"

namespace candela {
namespace {

constexpr LightEntry kLights[] = {
    // name         create                       example
    {"point", &PointLight::Create, "type point color 0.9 0.9 0.9 attenuation 0.025"},
    {"directional", &DirectionalLight::Create, "type directional direction 0 -1 0 color 1 1 1"},
    {"spot", &SpotLight::Create, "type spot direction 0 -1 0 angle 40 color 1 1 1 attenuation 0.1"},
    {"area", &AreaLight::Create, "type area radiance 5 5 5"},
    {"projector", &ProjectorLight::Create,
     "type projector image texture slide direction 0 -1 0 up 0 0 -1 fov 80 attenuation 0.1"},
    {"ies", &IesLight::Create, "type ies file ../lamps/downlight.ies"},
};

}  // namespace

std::span<const LightEntry> LightEntries() {
  return kLights;
}

std::unique_ptr<Light> CreateLight(const TypedSpec& spec, const LightContext& context,
                                   Diagnostics* diagnostics) {
  const LightEntry* entry = FindEntry<LightEntry>(kLights, spec, "light", diagnostics);
  if (!entry) return nullptr;
  ParamReader params(spec.params, entry->name, spec.where, diagnostics, context.resolved);
  auto light = entry->create(&params, context);
  const LightGroup group = ReadLightGroup(&params);
  if (context.group) *context.group = group;
  params.Finish();
  return light;
}

}  // namespace candela
