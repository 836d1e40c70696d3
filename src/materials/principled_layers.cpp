#include "materials/principled_layers.h"

#include "materials/dielectric_lobe.h"
#include "math/elementary.h"

namespace candela {
namespace {

std::shared_ptr<const BaseEnergy> BaseOf(std::optional<float> ior, const Roughness& roughness,
                                         const NumberInput& anisotropy, EnergyStore* energies) {
  EnergyStore own;
  return (energies ? energies : &own)->OfBase(ior, roughness, anisotropy);
}

}  // namespace

PrincipledLayers::PrincipledLayers(float ior, const Roughness& roughness,
                                   const NumberInput& anisotropy, float rotation_degrees,
                                   EnergyStore* energies)
    : eta(ior),
      cos_rotation(static_cast<float>(CosDegrees(static_cast<double>(rotation_degrees)))),
      sin_rotation(static_cast<float>(SinDegrees(static_cast<double>(rotation_degrees)))),
      dielectric(BaseOf(ior, roughness, anisotropy, energies)),
      metal(BaseOf(std::nullopt, roughness, anisotropy, energies)) {}

void PrincipledLayers::AddCoat(const Roughness& roughness) {
  coat.emplace(roughness.MakeTable(
      [](const Ggx& surface, Vec3 wo, Vec3 m) { return CoatFacet(kCoatIndex, surface, wo, m); }));
  mean_products_ = dielectric->MeansOfProduct(*coat);
}

}  // namespace candela
