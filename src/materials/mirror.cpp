#include "materials/mirror.h"

namespace candela {

std::unique_ptr<Material> MirrorMaterial::Create(ParamReader* params) {
  return std::make_unique<MirrorMaterial>(params->Albedo("reflectance", {1, 1, 1}));
}

PhongTerms MirrorMaterial::Phong(const SurfacePoint&) const {
  return {{}, {}, reflectance_, ShininessOf(0)};
}

void MirrorMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  bsdf->Add({LobeKind::kMirror, 1, Spectrum(reflectance_)});
}

}  // namespace candela
