#include "materials/principled_layers.h"

#include <algorithm>
#include <cmath>

#include "materials/dielectric_lobe.h"
#include "math/elementary.h"

namespace candela {
namespace {

EnergyTable::Facet CoatOf(float ior) {
  return [ior](const Ggx& surface, Vec3 wo, Vec3 m) { return CoatFacet(ior, surface, wo, m); };
}

EnergyTable TableOf(const Roughness& roughness, bool has_all, const EnergyTable::Facet& facet) {
  return has_all ? EnergyTable::OfAllRoughness(facet, EnergyTable::Detail::kSmooth)
                 : roughness.MakeTable(facet);
}

}  // namespace

PrincipledLayers::PrincipledLayers(float ior, const Ggx& brushed, float rotation_degrees)
    : eta(ior),
      cos_rotation(static_cast<float>(CosDegrees(static_cast<double>(rotation_degrees)))),
      sin_rotation(static_cast<float>(SinDegrees(static_cast<double>(rotation_degrees)))),
      is_row_by_azimuth(true),
      dielectric(EnergyTable::OfAnisotropic(brushed, CoatOf(ior))),
      metal(EnergyTable::OfAnisotropic(brushed, MirrorFacet)),
      is_row_by_roughness_(false) {}

PrincipledLayers::PrincipledLayers(float ior, const Roughness& roughness, bool is_brushing_textured,
                                   float rotation_degrees)
    : eta(ior),
      cos_rotation(static_cast<float>(CosDegrees(static_cast<double>(rotation_degrees)))),
      sin_rotation(static_cast<float>(SinDegrees(static_cast<double>(rotation_degrees)))),
      is_row_by_azimuth(false),
      dielectric(TableOf(roughness, is_brushing_textured, CoatOf(ior))),
      metal(TableOf(roughness, is_brushing_textured, MirrorFacet)),
      is_row_by_roughness_(dielectric.RowCount() > 1) {}

void PrincipledLayers::AddCoat(const Roughness& roughness) {
  coat.emplace(roughness.MakeTable(CoatOf(kCoatIndex)));
  const int rows = is_row_by_azimuth ? 1 : dielectric.RowCount();
  for (int row = 0; row < rows; ++row) {
    for (int coat_row = 0; coat_row < coat->RowCount(); ++coat_row) {
      mean_products_.push_back(
          is_row_by_azimuth
              ? EnergyTable::MeanOfProduct(dielectric, 0, dielectric.RowCount(), *coat, coat_row)
              : EnergyTable::MeanOfProduct(dielectric, row, 1, *coat, coat_row));
    }
  }
}

float PrincipledLayers::RowOf(const Ggx& at) const {
  return is_row_by_roughness_ ? EnergyTable::RowOfRoughness(std::min(at.alpha_x, at.alpha_y)) : 0;
}

float PrincipledLayers::MeanProduct(float row, float coat_row) const {
  const auto columns = static_cast<size_t>(coat->RowCount());
  const size_t rows = mean_products_.size() / columns;
  const auto at = [](float position, size_t size) {
    const auto index = static_cast<size_t>(std::max(position, 0.0f));
    return std::min(index, size - 1);
  };
  const size_t y = at(row, rows), x = at(coat_row, columns);
  const size_t y1 = std::min(y + 1, rows - 1), x1 = std::min(x + 1, columns - 1);
  const float v = row - static_cast<float>(y), u = coat_row - static_cast<float>(x);
  const auto blend = [u](const float* values, size_t a, size_t b) {
    return values[a] * (1 - u) + values[b] * u;
  };
  return blend(&mean_products_[y * columns], x, x1) * (1 - v) +
         blend(&mean_products_[y1 * columns], x, x1) * v;
}

}  // namespace candela
