#include "materials/pane.h"

#include "materials/fresnel.h"

namespace candela {

PhongTerms PaneMaterial::Phong(const SurfacePoint&) const {
  return PhongTermsOfGlass(pane_.ior, 0);
}

void PaneMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  Lobe lobe{LobeKind::kPane, 1, Spectrum(1)};
  lobe.pane = pane_;
  bsdf->Add(lobe);
}

PhongTerms PhongTermsOfGlass(float ior, float alpha) {
  const Rgb ground{0.1f, 0.1f, 0.1f};
  float beyond;
  const float reflectance = DielectricReflectance(1, ior, &beyond);
  return {ground, ground, {reflectance, reflectance, reflectance}, ShininessOf(alpha)};
}

}  // namespace candela
