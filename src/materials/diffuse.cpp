#include "materials/diffuse.h"

#include <utility>

namespace candela {

std::unique_ptr<Material> DiffuseMaterial::Create(ParamReader* params,
                                                  const MaterialContext& context) {
  ColorInput albedo = ColorInput::Albedo(params, "albedo", {0.5f, 0.5f, 0.5f}, context);
  NumberInput roughness = NumberInput::Fraction(params, "roughness", 0, context);
  return std::make_unique<DiffuseMaterial>(std::move(albedo), std::move(roughness));
}

PhongTerms DiffuseMaterial::Phong(const SurfacePoint& point) const {
  const Rgb albedo = albedo_.At(point);
  return {albedo, albedo, {}, 0};
}

void DiffuseMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const float roughness = roughness_.At(point);
  const bool is_rough = roughness > 0;
  Lobe lobe{is_rough ? LobeKind::kOrenNayar : LobeKind::kLambert, 1, Spectrum(albedo_.At(point))};
  if (is_rough) lobe.oren_nayar.roughness = roughness;
  bsdf->Add(lobe);
}

}  // namespace candela
