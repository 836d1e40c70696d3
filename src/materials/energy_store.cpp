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
  // Bases that hardly differ from what is outside have `FilmedRatio` and key in common: what is in
  // their tables differs as little.
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

std::shared_ptr<const FilmTable> EnergyStore::OfFilm(const FilmKey& key) {
  const auto& [film, outside, eta, k, least, most] = key;
  std::shared_ptr<const FilmTable>& table =
      films_[{film, outside, double{eta.x}, double{eta.y}, double{eta.z}, double{k.x}, double{k.y},
              double{k.z}, double{least}, double{most}}];
  if (!table) table = std::make_shared<const FilmTable>(film, outside, eta, k, least, most);
  return table;
}

std::shared_ptr<const BaseEnergy> EnergyStore::OfBase(std::optional<float> ior,
                                                      const Roughness& roughness,
                                                      const NumberInput& anisotropy) {
  const float brushing = anisotropy.IsTextured() ? -1 : anisotropy.value();
  std::shared_ptr<const BaseEnergy>& base = bases_[{ior.value_or(-1), KeyOf(roughness), brushing}];
  if (!base) {
    EnergyTable::Facet facet = MirrorFacet;
    if (ior) {
      facet = [index = *ior](const Ggx& surface, Vec3 wo, Vec3 m) {
        return CoatFacet(index, surface, wo, m);
      };
    }
    base = std::make_shared<const BaseEnergy>(roughness, anisotropy, facet);
  }
  return base;
}

}  // namespace candela
