#include "materials/dielectric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/dielectric_lobe.h"
#include "materials/pane.h"

namespace candela {
namespace {

/// Boundaries that hardly refract are taken as polished: there is no telling which facet leads from
/// one direction to the other.
constexpr float kLeastContrast = 1e-3f;

EnergyTable EnergyOf(float eta, const Roughness& roughness) {
  return roughness.MakeTable(
      [eta](const Ggx& surface, Vec3 wo, Vec3 m) { return DielectricFacet(eta, surface, wo, m); },
      EnergyTable::Detail::kEdge);
}

}  // namespace

std::unique_ptr<Material> DielectricMaterial::Create(ParamReader* params,
                                                     const MaterialContext& context) {
  const Medium medium = Medium::Create(params, 1.5f);
  if (params->Flag("thin", false)) {
    if (!medium.dispersion.IsNone()) {
      params->Error(params->Where("thin"), "a thin pane splits no light: it has no dispersion");
    }
    const Rgb depth = medium.absorption * params->NonNegative("thickness", 0);
    return std::make_unique<PaneMaterial>(medium.ior, depth);
  }
  return std::make_unique<DielectricMaterial>(medium, Roughness::Create(params, context),
                                              context.indices);
}

DielectricMaterial::DielectricMaterial(const Medium& medium, Roughness roughness,
                                       std::span<const float> indices)
    : medium_(medium), roughness_(std::move(roughness)) {
  if (roughness_.IsNowhere()) return;
  AddTables(1, medium.ior);
  for (size_t i = 0; i < indices.size(); ++i) {
    for (size_t j = 0; j < i; ++j) AddTables(indices[i], indices[j]);
  }
}

void DielectricMaterial::AddTables(float index_a, float index_b) {
  const float eta = index_b / index_a;
  if (std::abs(eta - 1) < kLeastContrast) return;
  const bool is_there = std::any_of(tables_.begin(), tables_.end(), [&](const Tables& tables) {
    return std::minmax(tables.index_a, tables.index_b) == std::minmax(index_a, index_b);
  });
  if (is_there) return;
  tables_.push_back({index_a, index_b, EnergyOf(eta, roughness_), EnergyOf(1 / eta, roughness_)});
}

PhongTerms DielectricMaterial::Phong(const SurfacePoint& point) const {
  return PhongTermsOfGlass(medium_.ior, roughness_.AlphaAt(point));
}

void DielectricMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const Medium *here = bsdf->medium_here, *beyond = bsdf->medium_beyond;
  if (!here) {
    const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
    here = is_outside ? &kAir : &medium_;
    beyond = is_outside ? &medium_ : &kAir;
  }
  const bool is_dispersive = !here->dispersion.IsNone() || !beyond->dispersion.IsNone();
  const float wavelength = is_dispersive ? bsdf->wavelength : 0;
  if (wavelength != 0) bsdf->is_dispersive = true;
  const float alpha = roughness_.AlphaAt(point);
  Lobe lobe{LobeKind::kSmoothDielectric, 1, Spectrum(1)};
  const float eta = beyond->IndexAt(wavelength) / here->IndexAt(wavelength);
  lobe.dielectric = {eta, {alpha, alpha}, nullptr, nullptr, 0};
  if (alpha >= kSmoothestAlpha) {
    for (const Tables& tables : tables_) {
      const bool is_from_a = tables.index_a == here->ior && tables.index_b == beyond->ior;
      if (!is_from_a && !(tables.index_b == here->ior && tables.index_a == beyond->ior)) continue;
      lobe.kind = LobeKind::kDielectric;
      lobe.dielectric.energy_here = is_from_a ? &tables.from_a : &tables.from_b;
      lobe.dielectric.energy_beyond = is_from_a ? &tables.from_b : &tables.from_a;
      lobe.dielectric.table_row = roughness_.TableRow(alpha);
      break;
    }
  }
  bsdf->Add(lobe);
}

}  // namespace candela
