#include "materials/energy_store.h"

#include <vector>

#include "materials/dielectric_lobe.h"

namespace candela {
namespace {

float KeyOf(const Roughness& roughness) {
  return roughness.IsTextured() ? -1 : roughness.AlphaAt({});
}

}  // namespace

std::shared_ptr<const EnergyTable> EnergyStore::OfDielectric(float eta,
                                                             const Roughness& roughness) {
  std::shared_ptr<const EnergyTable>& table = tables_[{eta, KeyOf(roughness)}];
  if (!table) {
    const auto facet = [eta](const Ggx& surface, Vec3 wo, Vec3 m) {
      return DielectricFacet(eta, surface, wo, m);
    };
    table =
        std::make_shared<const EnergyTable>(roughness.MakeTable(facet, EnergyTable::Detail::kEdge));
  }
  return table;
}

std::shared_ptr<const EnergyTable> EnergyStore::OfFilmedDielectric(float eta,
                                                                   const FilmParams& film,
                                                                   const Roughness& roughness) {
  std::shared_ptr<const EnergyTable>& table =
      tables_[{eta, KeyOf(roughness), film.ior, film.outside, film.thickness, film.wavelength}];
  if (!table) {
    DielectricParams glass{};
    glass.eta = eta;
    glass.film = film;
    const int count = film.wavelength == 0 ? 3 : 1;
    const auto tables = std::make_shared<std::vector<EnergyTable>>();
    for (int c = 0; c < count; ++c) {
      tables->push_back(roughness.MakeTable(
          [&](const Ggx& surface, Vec3 wo, Vec3 m) { return FilmFacet(glass, c, surface, wo, m); },
          EnergyTable::Detail::kEdge));
    }
    table = {tables, &(*tables)[static_cast<size_t>(count / 2)]};
  }
  return table;
}

}  // namespace candela
