#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "materials/base_energy.h"
#include "materials/energy_store.h"
#include "materials/energy_table.h"
#include "materials/roughness.h"
#include "materials/sheen_table.h"

namespace candela {

/// What is the same for all points of a `principled` surface: what its layers reflect of the light
/// from each direction.
class PrincipledLayers {
 public:
  /// The refractive index of the clear coat.
  static constexpr float kCoatIndex = 1.5f;

  /// `energies` has the tables of other materials; see `MaterialContext`.
  PrincipledLayers(float ior, const Roughness& roughness, const NumberInput& anisotropy,
                   float rotation_degrees, EnergyStore* energies);

  /// What the parts below ask for; to be called before these are used.
  void AddCoat(const Roughness& roughness);
  void AddSheen() { sheen = &SheenTable::Get(); }

  /// The mean, weighted by the cosine, of what the coat times the dielectric base below reflects.
  float MeanProduct(const BaseEnergy::Place& at, float coat_row) const {
    return dielectric->MeanOfProduct(mean_products_, at, coat_row);
  }

  float eta;                         ///< The refractive index of the dielectric part.
  float cos_rotation, sin_rotation;  ///< Of the brushing, in the frame.
  std::shared_ptr<const BaseEnergy> dielectric, metal;
  std::optional<EnergyTable> coat;
  const SheenTable* sheen = nullptr;

 private:
  std::vector<float> mean_products_;  ///< As `BaseEnergy` makes them.
};

}  // namespace candela
