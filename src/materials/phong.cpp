#include "materials/phong.h"

#include <algorithm>

namespace candela {

std::unique_ptr<Material> PhongMaterial::Create(ParamReader* params) {
  PhongTerms terms;
  terms.diffuse = params->Color("diffuse", {1, 1, 1});
  terms.ambient = params->Has("diffuse") ? terms.diffuse : Rgb();
  terms.specular = params->Color("specular", {0, 0, 0});
  terms.shininess = params->Number("shininess", 0);
  const bool is_normalised = params->Flag("normalised", false);
  auto material = std::make_unique<PhongMaterial>(terms, is_normalised);
  if (is_normalised && (!material->IsPhysical() || terms.shininess < 0)) {
    params->Error(params->Where("normalised"),
                  "a normalised 'phong' needs a 'diffuse' and a 'specular' colour that are not "
                  "negative and together at most 1, and a 'shininess' that is not negative");
  }
  return material;
}

void PhongMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  const auto largest = [](Rgb c) { return std::max({c.x, c.y, c.z}); };
  bsdf->Add({LobeKind::kLambert, largest(terms_.diffuse), Spectrum(terms_.diffuse)});
  if (!is_normalised_ || terms_.specular == Rgb()) return;
  Lobe highlight{LobeKind::kPhong, largest(terms_.specular), Spectrum(terms_.specular)};
  highlight.phong.exponent = terms_.shininess;
  bsdf->Add(highlight);
}

bool PhongMaterial::IsPhysical() const {
  const auto is_share = [](Rgb c) {
    return std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1;
  };
  if (!is_normalised_) return terms_.specular == Rgb() && is_share(terms_.diffuse);
  return is_share(terms_.diffuse) && is_share(terms_.specular) &&
         is_share(terms_.diffuse + terms_.specular);
}

}  // namespace candela
