#include "materials/plastic.h"

#include <utility>

#include "materials/dielectric_lobe.h"
#include "materials/fresnel.h"
#include "materials/medium.h"

namespace candela {

std::unique_ptr<Material> PlasticMaterial::Create(ParamReader* params,
                                                  const MaterialContext& context) {
  ColorInput albedo = ColorInput::Albedo(params, "albedo", {0.5f, 0.5f, 0.5f}, context);
  const float ior = ReadRefractiveIndex(params, "ior", 1.5f);
  if (!(ior > 1)) {
    params->Error(params->Where("ior"), "the coat of 'plastic' has an 'ior' above 1");
  }
  return std::make_unique<PlasticMaterial>(std::move(albedo), ior,
                                           Roughness::Create(params, context));
}

PlasticMaterial::PlasticMaterial(ColorInput albedo, float ior, Roughness roughness)
    : albedo_(std::move(albedo)),
      ior_(ior),
      mean_reflectance_(MeanDielectricReflectance(ior)),
      roughness_(std::move(roughness)) {
  if (roughness_.IsNowhere()) return;
  energy_ = roughness_.MakeTable(
      [ior](const Ggx& surface, Vec3 wo, Vec3 m) { return CoatFacet(ior, surface, wo, m); });
}

PhongTerms PlasticMaterial::Phong(const SurfacePoint& point) const {
  const Rgb albedo = albedo_.At(point);
  float beyond;
  const float coat = DielectricReflectance(1, ior_, &beyond);
  return {albedo, albedo, {coat, coat, coat}, ShininessOf(roughness_.AlphaAt(point))};
}

void PlasticMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const float alpha = roughness_.AlphaAt(point);
  Lobe lobe{LobeKind::kPlastic, 1, Spectrum(albedo_.At(point))};
  lobe.plastic = {ior_, {alpha, alpha}, mean_reflectance_, nullptr, 0};
  if (alpha >= kSmoothestAlpha) {
    lobe.plastic.energy = &*energy_;
    lobe.plastic.table_row = roughness_.TableRow(alpha);
    lobe.plastic.mean_share = energy_->Mean(lobe.plastic.table_row);
  }
  bsdf->Add(lobe);
}

}  // namespace candela
