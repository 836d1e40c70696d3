#include "materials/phong.h"

#include <algorithm>

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
  return material;
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
  const Rgb diffuse = diffuse_.value(), specular = specular_.value();
  if (!is_normalised_) {
    return !specular_.IsTextured() && specular == Rgb() &&
           (diffuse_.IsTextured() || IsShare(diffuse));
  }
  const bool is_limited = diffuse_.IsTextured() || specular_.IsTextured();
  return IsShare(diffuse) && IsShare(specular) && (is_limited || IsShare(diffuse + specular));
}

}  // namespace candela
