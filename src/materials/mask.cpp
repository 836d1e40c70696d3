#include "materials/mask.h"

namespace candela {

std::unique_ptr<Material> MaskMaterial::Create(ParamReader* params,
                                               const MaterialContext& context) {
  const std::string name = params->RequiredWord("material");
  const Material* material =
      name.empty() ? nullptr : context.find_material(name, params->Where("material"));
  NumberInput opacity = NumberInput::Fraction(params, "opacity", 1, context);
  if (!material) return nullptr;
  if (material->MostLobes() == Bsdf::kMostLobes) {
    params->Error(params->Where("material"), "a mask cannot be laid on a mixture of so many parts");
    return nullptr;
  }
  return std::make_unique<MaskMaterial>(*material, std::move(opacity));
}

void MaskMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const float opacity = opacity_.At(point);
  if (opacity > 0) {
    const int first_lobe = bsdf->count;
    material_.Evaluate(point, bsdf);
    bsdf->Mix(first_lobe, opacity);
  }
  if (opacity == 1) return;
  const int hole = bsdf->count;
  bsdf->Add({LobeKind::kHole, 1, Spectrum(1)});
  bsdf->Mix(hole, 1 - opacity);
}

}  // namespace candela
