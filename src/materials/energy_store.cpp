#include "materials/energy_store.h"

#include "materials/dielectric_lobe.h"

namespace candela {

std::shared_ptr<const EnergyTable> EnergyStore::OfDielectric(float eta,
                                                             const Roughness& roughness) {
  const float alpha = roughness.IsTextured() ? -1 : roughness.AlphaAt({});
  std::shared_ptr<const EnergyTable>& table = tables_[{eta, alpha}];
  if (!table) {
    const auto facet = [eta](const Ggx& surface, Vec3 wo, Vec3 m) {
      return DielectricFacet(eta, surface, wo, m);
    };
    table =
        std::make_shared<const EnergyTable>(roughness.MakeTable(facet, EnergyTable::Detail::kEdge));
  }
  return table;
}

}  // namespace candela
