#include "materials/one_sided.h"

#include <utility>

namespace candela {

std::unique_ptr<Material> OneSidedMaterial::Applied(std::unique_ptr<Material> material,
                                                    ParamReader* params) {
  if (params->Flag("two_sided", true) || !material) return material;
  if (material->Body()) {
    params->Error(params->Where("two_sided"), "a surface that lets light in has two sides");
    return material;
  }
  return std::make_unique<OneSidedMaterial>(std::move(material));
}

void OneSidedMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  if (Dot(point.n_shading, bsdf->frame.z) > 0) {
    material_->Evaluate(point, bsdf);
    return;
  }
  const float transparency = material_->Transparency(point);
  if (transparency == 0) return;
  const int hole = bsdf->count;
  bsdf->Add({LobeKind::kHole, 1, Spectrum(1)});
  bsdf->Mix(hole, transparency);
}

}  // namespace candela
