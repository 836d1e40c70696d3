#include "materials/diffuse.h"

#include <algorithm>

namespace candela {

std::unique_ptr<Material> DiffuseMaterial::Create(ParamReader* params) {
  const Rgb albedo = params->Albedo("albedo", {0.5f, 0.5f, 0.5f});
  return std::make_unique<DiffuseMaterial>(albedo, params->Fraction("roughness", 0));
}

void DiffuseMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  const bool is_rough = roughness_ > 0;
  Lobe lobe{is_rough ? LobeKind::kOrenNayar : LobeKind::kLambert, 1, Spectrum(albedo_)};
  if (is_rough) lobe.oren_nayar.roughness = roughness_;
  bsdf->Add(lobe);
}

}  // namespace candela
