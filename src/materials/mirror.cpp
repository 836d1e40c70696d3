#include "materials/mirror.h"

namespace candela {

std::unique_ptr<Material> MirrorMaterial::Create(ParamReader* params,
                                                 const MaterialContext& context) {
  return std::make_unique<MirrorMaterial>(
      ColorInput::Albedo(params, "reflectance", {1, 1, 1}, context));
}

PhongTerms MirrorMaterial::Phong(const SurfacePoint& point) const {
  return {{}, {}, reflectance_.At(point), ShininessOf(0)};
}

void MirrorMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  bsdf->Add({LobeKind::kMirror, 1, Spectrum(reflectance_.At(point))});
}

}  // namespace candela
