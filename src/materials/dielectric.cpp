#include "materials/dielectric.h"

#include <cmath>
#include <utility>

#include "materials/dielectric_lobe.h"
#include "materials/pane.h"
#include "materials/refractive_index.h"

namespace candela {
namespace {

/// Boundaries that hardly refract are taken as polished: there is no telling which facet leads from
/// one direction to the other.
constexpr float kLeastContrast = 1e-3f;

EnergyTable EnergyOf(float eta, const Roughness& roughness) {
  return roughness.MakeTable(
      [eta](const Ggx& surface, Vec3 wo, Vec3 m) { return DielectricFacet(eta, surface, wo, m); });
}

}  // namespace

std::unique_ptr<Material> DielectricMaterial::Create(ParamReader* params,
                                                     const MaterialContext& context) {
  const float ior = ReadRefractiveIndex(params, "ior", 1.5f);
  const Rgb absorption = params->NonNegativeColor("absorption", {0, 0, 0});
  if (params->Flag("thin", false)) {
    return std::make_unique<PaneMaterial>(ior, absorption * params->NonNegative("thickness", 0));
  }
  return std::make_unique<DielectricMaterial>(ior, Roughness::Create(params, context), absorption);
}

DielectricMaterial::DielectricMaterial(float ior, Roughness roughness, Rgb absorption)
    : ior_(ior), roughness_(std::move(roughness)), absorption_(absorption) {
  if (roughness_.IsNowhere() || std::abs(ior - 1) < kLeastContrast) return;
  outside_ = EnergyOf(ior, roughness_);
  inside_ = EnergyOf(1 / ior, roughness_);
}

PhongTerms DielectricMaterial::Phong(const SurfacePoint& point) const {
  return PhongTermsOfGlass(ior_, roughness_.AlphaAt(point));
}

void DielectricMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
  const float alpha = roughness_.AlphaAt(point);
  const bool is_rough = outside_ && alpha >= kSmoothestAlpha;
  Lobe lobe{is_rough ? LobeKind::kDielectric : LobeKind::kSmoothDielectric, 1, Spectrum(1)};
  lobe.dielectric = {is_outside ? ior_ : 1 / ior_, {alpha, alpha}, nullptr, nullptr, 0};
  if (is_rough) {
    lobe.dielectric.energy_here = is_outside ? &*outside_ : &*inside_;
    lobe.dielectric.energy_beyond = is_outside ? &*inside_ : &*outside_;
    lobe.dielectric.table_row = roughness_.TableRow(alpha);
  }
  bsdf->Add(lobe);
}

}  // namespace candela
