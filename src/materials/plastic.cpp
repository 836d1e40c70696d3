#include "materials/plastic.h"

#include "materials/dielectric_lobe.h"
#include "materials/fresnel.h"
#include "materials/refractive_index.h"

namespace candela {

std::unique_ptr<Material> PlasticMaterial::Create(ParamReader* params) {
  const Rgb albedo = params->Albedo("albedo", {0.5f, 0.5f, 0.5f});
  const float ior = ReadRefractiveIndex(params, "ior", 1.5f);
  if (!(ior > 1)) {
    params->Error(params->Where("ior"), "the coat of 'plastic' has an 'ior' above 1");
  }
  const float roughness = params->Fraction("roughness", 0);
  return std::make_unique<PlasticMaterial>(albedo, ior, roughness * roughness);
}

PlasticMaterial::PlasticMaterial(Rgb albedo, float ior, float alpha)
    : albedo_(albedo), coat_{ior, {alpha, alpha}, MeanDielectricReflectance(ior), nullptr, 0} {
  if (alpha < kSmoothestAlpha) return;
  energy_ = EnergyTable::OfRoughness(
      alpha, [ior](const Ggx& surface, Vec3 wo, Vec3 m) { return CoatFacet(ior, surface, wo, m); });
  coat_.energy = &*energy_;
  coat_.mean_share = energy_->Mean(0);
}

PhongTerms PlasticMaterial::Phong(const SurfacePoint&) const {
  float beyond;
  const float coat = DielectricReflectance(1, coat_.eta, &beyond);
  return {albedo_, albedo_, {coat, coat, coat}, ShininessOf(coat_.surface.alpha_x)};
}

void PlasticMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  Lobe lobe{LobeKind::kPlastic, 1, Spectrum(albedo_)};
  lobe.plastic = coat_;
  bsdf->Add(lobe);
}

}  // namespace candela
