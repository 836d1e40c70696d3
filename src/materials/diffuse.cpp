#include "materials/diffuse.h"

#include <algorithm>

namespace candela {

std::unique_ptr<Material> DiffuseMaterial::Create(ParamReader* params) {
  return std::make_unique<DiffuseMaterial>(params->Albedo("albedo", {0.5f, 0.5f, 0.5f}));
}

void DiffuseMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  bsdf->Add({LobeKind::kLambert, 1, Spectrum(albedo_), {}});
}

}  // namespace candela
