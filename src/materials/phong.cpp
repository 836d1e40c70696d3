#include "materials/phong.h"

#include <fmt/format.h>

#include <algorithm>

#include "materials/medium.h"

namespace candela {
namespace {

bool IsShare(Rgb c) {
  return std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1;
}

float Largest(Rgb c) {
  return std::max({c.x, c.y, c.z});
}

}  // namespace

PhongMaterial::PhongMaterial(const PhongTerms& terms, bool is_normalised)
    : diffuse_(terms.diffuse),
      specular_(terms.specular),
      has_ambient_(terms.ambient != Rgb()),
      shininess_(terms.shininess),
      is_normalised_(is_normalised) {}

std::unique_ptr<Material> PhongMaterial::Create(ParamReader* params,
                                                const MaterialContext& context) {
  std::unique_ptr<PhongMaterial> material(new PhongMaterial());
  // Without a colour lights find a white surface, but the ambient light a black one.
  constexpr Rgb kWhite{1, 1, 1};
  material->has_ambient_ = params->Has("diffuse");
  material->diffuse_ = material->has_ambient_
                           ? ColorInput::Color(params, "diffuse", kWhite, context)
                           : ColorInput(kWhite);
  material->specular_ = ColorInput::Color(params, "specular", {0, 0, 0}, context);
  material->shininess_ = params->Number("shininess", 0);
  material->is_normalised_ = params->Flag("normalised", false);
  if (material->is_normalised_ && (!material->IsPhysical() || material->shininess_ < 0)) {
    params->Error(params->Where("normalised"),
                  "a normalised 'phong' needs a 'diffuse' and a 'specular' colour that are not "
                  "negative and together at most 1, and a 'shininess' that is not negative");
  }
  material->ReadOptics(params, context);
  return material;
}

void PhongMaterial::ReadOptics(ParamReader* params, const MaterialContext& context) {
  if (params->Has("reflection_roughness")) {
    reflection_roughness_ = NumberInput::Fraction(params, "reflection_roughness", 0, context);
    is_glossy_ = reflection_roughness_.IsTextured() || reflection_roughness_.value() > 0;
  }
  if (params->Has("transmittance")) {
    transmittance_ = ColorInput::Albedo(params, "transmittance", {0, 0, 0}, context);
    is_transparent_ = transmittance_.IsTextured() || transmittance_.value() != Rgb();
    ior_ = ReadRefractiveIndex(params, "ior", 1.5f);
    absorption_ = params->NonNegativeColor("absorption", {0, 0, 0});
  } else {
    for (const char* name : {"ior", "absorption"}) {
      if (!params->Has(name)) continue;
      params->Error(params->Where(name),
                    fmt::format("'{}' is for a 'transmittance', of which there is none", name));
    }
  }
  if (is_normalised_ && HasOptics()) {
    params->Error(
        params->Where("normalised"),
        "a normalised 'phong' has no 'transmittance' and no 'reflection_roughness', which "
        "light transport does not know of it");
  }
}

PhongOptics PhongMaterial::Optics(const SurfacePoint& point) const {
  return {reflection_roughness_.At(point), transmittance_.At(point), ior_, absorption_};
}

PhongTerms PhongMaterial::Phong(const SurfacePoint& point) const {
  const Rgb diffuse = diffuse_.At(point);
  return {has_ambient_ ? diffuse : Rgb(), diffuse, specular_.At(point), shininess_};
}

void PhongMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  // Textures may go beyond what a surface can throw back.
  Rgb diffuse = Max(Rgb(), diffuse_.At(point));
  Rgb specular = is_normalised_ ? Max(Rgb(), specular_.At(point)) : Rgb();
  const float most = Largest(diffuse + specular);
  if (most > 1) {
    diffuse *= 1 / most;
    specular *= 1 / most;
  }
  bsdf->Add({LobeKind::kLambert, Largest(diffuse), Spectrum(diffuse)});
  if (specular == Rgb()) return;
  Lobe highlight{LobeKind::kPhong, Largest(specular), Spectrum(specular)};
  highlight.phong.exponent = shininess_;
  bsdf->Add(highlight);
}

bool PhongMaterial::IsPhysical() const {
  if (HasOptics()) return false;
  const Rgb diffuse = diffuse_.value(), specular = specular_.value();
  if (!is_normalised_) {
    return !specular_.IsTextured() && specular == Rgb() &&
           (diffuse_.IsTextured() || IsShare(diffuse));
  }
  const bool is_limited = diffuse_.IsTextured() || specular_.IsTextured();
  return IsShare(diffuse) && IsShare(specular) && (is_limited || IsShare(diffuse + specular));
}

}  // namespace candela
