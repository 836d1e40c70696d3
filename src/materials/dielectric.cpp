#include "materials/dielectric.h"

#include <cmath>

#include "materials/dielectric_lobe.h"
#include "materials/pane.h"
#include "materials/refractive_index.h"

namespace candela {
namespace {

/// Boundaries that hardly refract are taken as polished: there is no telling which facet leads from
/// one direction to the other.
constexpr float kLeastContrast = 1e-3f;

EnergyTable EnergyOf(float eta, float alpha) {
  return EnergyTable::OfRoughness(alpha, [eta](const Ggx& surface, Vec3 wo, Vec3 m) {
    return DielectricFacet(eta, surface, wo, m);
  });
}

}  // namespace

std::unique_ptr<Material> DielectricMaterial::Create(ParamReader* params) {
  const float ior = ReadRefractiveIndex(params, "ior", 1.5f);
  const Rgb absorption = params->NonNegativeColor("absorption", {0, 0, 0});
  if (params->Flag("thin", false)) {
    return std::make_unique<PaneMaterial>(ior, absorption * params->NonNegative("thickness", 0));
  }
  const float roughness = params->Fraction("roughness", 0);
  return std::make_unique<DielectricMaterial>(ior, roughness * roughness, absorption);
}

DielectricMaterial::DielectricMaterial(float ior, float alpha, Rgb absorption)
    : ior_(ior), alpha_(alpha), absorption_(absorption) {
  if (alpha < kSmoothestAlpha || std::abs(ior - 1) < kLeastContrast) return;
  outside_ = EnergyOf(ior, alpha);
  inside_ = EnergyOf(1 / ior, alpha);
}

PhongTerms DielectricMaterial::Phong(const SurfacePoint&) const {
  return PhongTermsOfGlass(ior_, alpha_);
}

void DielectricMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
  Lobe lobe{outside_ ? LobeKind::kDielectric : LobeKind::kSmoothDielectric, 1, Spectrum(1)};
  lobe.dielectric = {is_outside ? ior_ : 1 / ior_, {alpha_, alpha_}, nullptr, nullptr, 0};
  if (outside_) {
    lobe.dielectric.energy_here = is_outside ? &*outside_ : &*inside_;
    lobe.dielectric.energy_beyond = is_outside ? &*inside_ : &*outside_;
  }
  bsdf->Add(lobe);
}

}  // namespace candela
