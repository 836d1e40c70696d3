#include "materials/registry.h"

#include <utility>

#include "materials/conductor.h"
#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/mask.h"
#include "materials/mirror.h"
#include "materials/mix.h"
#include "materials/one_sided.h"
#include "materials/phong.h"
#include "materials/plastic.h"
#include "materials/principled.h"
#include "materials/relief.h"
#include "materials/retroreflective.h"
#include "scene_spec/registry.h"

namespace candela {
namespace {

constexpr MaterialEntry kMaterials[] = {
    // name    create                    example
    {"phong", &PhongMaterial::Create, "diffuse 0.8 0.2 0.2 specular 0.5 0.5 0.5 shininess 20"},
    {"diffuse", &DiffuseMaterial::Create, "type diffuse albedo 0.8 0.8 0.8 roughness 0.5"},
    {"mirror", &MirrorMaterial::Create, "type mirror reflectance 0.9 0.9 0.9"},
    {"conductor", &ConductorMaterial::Create,
     "type conductor metal gold roughness 0.5 film_thickness 250"},
    {"dielectric", &DielectricMaterial::Create,
     "type dielectric ior glass roughness 0.5 film_thickness 300"},
    {"plastic", &PlasticMaterial::Create, "type plastic albedo 0.8 0.2 0.1 roughness 0.4"},
    {"mix", &MixMaterial::Create, "type mix first iron second clay amount 0.3"},
    {"mask", &MaskMaterial::Create, "type mask material clay opacity 0.6"},
    {"retroreflective", &RetroreflectiveMaterial::Create,
     "type retroreflective albedo 0.9 0.5 0.1 amount 0.6 roughness 0.4"},
    {"principled", &PrincipledMaterial::Create,
     "type principled base_color 0.7 0.3 0.1 metallic 0.3 roughness 0.5 clearcoat 0.5 "
     "clearcoat_roughness 0.3 sheen 0.5 anisotropy 0.4"},
};

}  // namespace

std::span<const MaterialEntry> MaterialEntries() {
  return kMaterials;
}

std::unique_ptr<Material> CreateMaterial(const TypedSpec& spec, const MaterialContext& context) {
  const MaterialEntry* entry =
      FindEntry<MaterialEntry>(kMaterials, spec, "material", context.diagnostics);
  if (!entry) return nullptr;
  ParamReader params(spec.params, entry->name, spec.where, context.diagnostics, context.resolved);
  // The loader has taken these; a parameter that was meant as one of them is told so.
  for (const std::string_view name : {"type", "name"}) params.Has(name);
  auto material = OneSidedMaterial::Applied(entry->create(&params, context), &params);
  material = ReliefMaterial::Applied(std::move(material), &params, context);
  params.Finish();
  if (material && material->Body() && material->HasHoles()) {
    params.Error(spec.where,
                 "a surface that lets light into a body cannot have holes: light that went through "
                 "one would be inside without having entered");
  }
  return material;
}

}  // namespace candela
