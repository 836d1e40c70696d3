#pragma once

#include <map>
#include <memory>
#include <utility>

#include "materials/energy_table.h"
#include "materials/roughness.h"

namespace candela {

/// The tables of rough dielectrics that a scene needs, each of which is made once: for all
/// roughnesses one takes a good part of a second. Not for concurrent use.
class EnergyStore {
 public:
  /// For light that comes to a boundary beyond which the refractive index is `eta` times as large.
  std::shared_ptr<const EnergyTable> OfDielectric(float eta, const Roughness& roughness);

 private:
  /// By index and alpha, or a negative number for all alphas.
  std::map<std::pair<float, float>, std::shared_ptr<const EnergyTable>> tables_;
};

}  // namespace candela
