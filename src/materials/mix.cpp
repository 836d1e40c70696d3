#include "materials/mix.h"

#include <fmt/format.h>

namespace candela {
namespace {

/// The material that a required parameter names; null when there is none, which is reported.
const Material* PartOf(ParamReader* params, std::string_view name, const MaterialContext& context) {
  const std::string word = params->RequiredWord(name);
  const Material* part = word.empty() ? nullptr : context.find_material(word, params->Where(name));
  if (part && part->BendsNormals()) {
    params->Error(params->Where(name),
                  "the parts of a mixture have the same normals: give the map to the mixture");
  }
  if (part && part->HasOptics()) {
    params->Error(params->Where(name),
                  "the parts of a mixture have no 'transmittance' and no 'reflection_roughness'");
  }
  return part;
}

}  // namespace

std::unique_ptr<Material> MixMaterial::Create(ParamReader* params, const MaterialContext& context) {
  const Material* first = PartOf(params, "first", context);
  const Material* second = PartOf(params, "second", context);
  NumberInput amount = NumberInput::Fraction(params, "amount", 0.5f, context);
  if (!first || !second) return nullptr;
  auto mix = std::make_unique<MixMaterial>(*first, *second, std::move(amount));
  if (mix->MostLobes() > Bsdf::kMostLobes) {
    params->Error(
        params->Where("second"),
        fmt::format("mixtures have at most {} parts, those of their parts included, where "
                    "'phong' counts as two",
                    Bsdf::kMostLobes));
    return nullptr;
  }
  return mix;
}

PhongTerms MixMaterial::Phong(const SurfacePoint& point) const {
  const PhongTerms a = first_.Phong(point), b = second_.Phong(point);
  const float t = amount_.At(point), s = 1 - t;
  return {a.ambient * s + b.ambient * t, a.diffuse * s + b.diffuse * t,
          a.specular * s + b.specular * t, a.shininess * s + b.shininess * t};
}

void MixMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const float amount = amount_.At(point);
  const auto add = [&](const Material& part, float share) {
    if (share == 0) return;
    const int first_lobe = bsdf->count;
    part.Evaluate(point, bsdf);
    bsdf->Mix(first_lobe, share);
  };
  add(first_, 1 - amount);
  add(second_, amount);
}

bool MixMaterial::NeedsTextureCoordinates() const {
  return amount_.NeedsTextureCoordinates() || first_.NeedsTextureCoordinates() ||
         second_.NeedsTextureCoordinates();
}

}  // namespace candela
