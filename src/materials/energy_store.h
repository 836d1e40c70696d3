#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>

#include "materials/base_energy.h"
#include "materials/energy_table.h"
#include "materials/lobe.h"
#include "materials/roughness.h"
#include "materials/thin_film.h"

namespace candela {

/// The tables of films, rough dielectrics and brushed surfaces that a scene needs, each of which is
/// made once: the larger ones take a good part of a second. Not for concurrent use.
class EnergyStore {
 public:
  /// For light that comes to a boundary beyond which the refractive index is `eta` times as large.
  std::shared_ptr<const EnergyTable> OfDielectric(float eta, const Roughness& roughness);

  /// The same under a film: for all light the middle one of three, as in `DielectricParams`, and
  /// for that of one wavelength the only one.
  std::shared_ptr<const EnergyTable> OfFilmedDielectric(float eta, const FilmParams& film,
                                                        const Roughness& roughness);

  /// What a `FilmTable` is made of.
  struct FilmKey {
    double film, outside;
    Rgb base_eta, base_k;
    float least, most;
  };
  std::shared_ptr<const FilmTable> OfFilm(const FilmKey& key);

  /// Of a coat of that refractive index, or of a mirror.
  std::shared_ptr<const BaseEnergy> OfBase(std::optional<float> ior, const Roughness& roughness,
                                           const NumberInput& anisotropy);

 private:
  /// By index and alpha, or a negative number for all alphas; and by the film.
  std::map<std::array<float, 6>, std::shared_ptr<const EnergyTable>> tables_;
  std::map<std::array<double, 10>, std::shared_ptr<const FilmTable>> films_;
  /// By index, alpha and anisotropy, or a negative number for none and for all of them.
  std::map<std::array<float, 3>, std::shared_ptr<const BaseEnergy>> bases_;
};

}  // namespace candela
