#include "materials/principled_layers.h"

#include "materials/dielectric_lobe.h"
#include "math/elementary.h"

namespace candela {
namespace {

EnergyTable::Facet CoatOf(float ior) {
  return [ior](const Ggx& surface, Vec3 wo, Vec3 m) { return CoatFacet(ior, surface, wo, m); };
}

}  // namespace

PrincipledLayers::PrincipledLayers(float ior, const Roughness& roughness,
                                   const NumberInput& anisotropy, float rotation_degrees)
    : eta(ior),
      cos_rotation(static_cast<float>(CosDegrees(static_cast<double>(rotation_degrees)))),
      sin_rotation(static_cast<float>(SinDegrees(static_cast<double>(rotation_degrees)))),
      dielectric(roughness, anisotropy, CoatOf(ior)),
      metal(roughness, anisotropy, MirrorFacet) {}

void PrincipledLayers::AddCoat(const Roughness& roughness) {
  coat.emplace(roughness.MakeTable(CoatOf(kCoatIndex)));
  mean_products_ = dielectric.MeansOfProduct(*coat);
}

}  // namespace candela
