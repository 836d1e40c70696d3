#include "materials/diffuse.h"

#include <algorithm>

namespace candela {

std::unique_ptr<Material> DiffuseMaterial::Create(ParamReader* params) {
  const Rgb albedo = params->Color("albedo", {0.5f, 0.5f, 0.5f});
  if (std::min({albedo.x, albedo.y, albedo.z}) < 0 ||
      std::max({albedo.x, albedo.y, albedo.z}) > 1) {
    params->Error(params->Where("albedo"), "'albedo' expects numbers from 0 to 1");
  }
  return std::make_unique<DiffuseMaterial>(albedo);
}

void DiffuseMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  bsdf->Add({LobeKind::kLambert, Spectrum(albedo_)});
}

}  // namespace candela
