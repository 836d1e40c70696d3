#include "materials/phong.h"

#include <algorithm>

namespace candela {

std::unique_ptr<Material> PhongMaterial::Create(ParamReader* params) {
  PhongTerms terms;
  terms.diffuse = params->Color("diffuse", {1, 1, 1});
  terms.ambient = params->Has("diffuse") ? terms.diffuse : Rgb();
  terms.specular = params->Color("specular", {0, 0, 0});
  terms.shininess = params->Number("shininess", 0);
  return std::make_unique<PhongMaterial>(terms);
}

void PhongMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  bsdf->Add({LobeKind::kLambert, 1, Spectrum(terms_.diffuse), {}});
}

bool PhongMaterial::IsPhysical() const {
  const Rgb albedo = terms_.diffuse;
  return terms_.specular == Rgb() && std::min({albedo.x, albedo.y, albedo.z}) >= 0 &&
         std::max({albedo.x, albedo.y, albedo.z}) <= 1;
}

}  // namespace candela
