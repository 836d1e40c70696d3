#include "materials/retroreflective.h"

#include <algorithm>
#include <utility>

namespace candela {

std::unique_ptr<Material> RetroreflectiveMaterial::Create(ParamReader* params,
                                                          const MaterialContext& context) {
  ColorInput albedo = ColorInput::Albedo(params, "albedo", {0.5f, 0.5f, 0.5f}, context);
  ColorInput reflectance = ColorInput::Albedo(params, "reflectance", {1, 1, 1}, context);
  NumberInput amount = NumberInput::Fraction(params, "amount", 0.5f, context);
  return std::make_unique<RetroreflectiveMaterial>(
      std::move(albedo), std::move(reflectance), std::move(amount),
      Roughness::Create(params, context, "roughness", 0.2f));
}

RetroreflectiveMaterial::RetroreflectiveMaterial(ColorInput albedo, ColorInput reflectance,
                                                 NumberInput amount, Roughness roughness)
    : albedo_(std::move(albedo)),
      reflectance_(std::move(reflectance)),
      amount_(std::move(amount)),
      roughness_(std::move(roughness)),
      energy_(roughness_.MakeTable(MirrorFacet)) {}

// What goes back to a light is not seen from elsewhere.
PhongTerms RetroreflectiveMaterial::Phong(const SurfacePoint& point) const {
  const Rgb ground = albedo_.At(point) * (1 - amount_.At(point));
  return {ground, ground, {}, 0};
}

void RetroreflectiveMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const float amount = amount_.At(point);
  const Spectrum ground(albedo_.At(point) * (1 - amount));
  bsdf->Add({LobeKind::kLambert, ground.MaxComponent(), ground});

  const float alpha = std::max(roughness_.AlphaAt(point), kSmoothestAlpha);
  const Spectrum back(reflectance_.At(point) * amount);
  Lobe lobe{LobeKind::kRetroreflector, back.MaxComponent(), back};
  // Of no index and any extinction above 0: it reflects all light.
  const Rgb none{0, 0, 0}, all{1, 1, 1};
  lobe.conductor = {none,  all, all, {alpha, alpha}, 1, 0, &energy_, roughness_.TableRow(alpha),
                    false, {}};
  bsdf->Add(lobe);
}

}  // namespace candela
