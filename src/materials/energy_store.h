#pragma once

#include <array>
#include <map>
#include <memory>

#include "materials/energy_table.h"
#include "materials/lobe.h"
#include "materials/roughness.h"

namespace candela {

/// The tables of rough dielectrics that a scene needs, each of which is made once: for all
/// roughnesses one takes a good part of a second. Not for concurrent use.
class EnergyStore {
 public:
  /// For light that comes to a boundary beyond which the refractive index is `eta` times as large.
  std::shared_ptr<const EnergyTable> OfDielectric(float eta, const Roughness& roughness);

  /// The same under a film: for all light the middle one of three, as in `DielectricParams`, and
  /// for that of one wavelength the only one.
  std::shared_ptr<const EnergyTable> OfFilmedDielectric(float eta, const FilmParams& film,
                                                        const Roughness& roughness);

 private:
  /// By index and alpha, or a negative number for all alphas; and by the film.
  std::map<std::array<float, 6>, std::shared_ptr<const EnergyTable>> tables_;
};

}  // namespace candela
