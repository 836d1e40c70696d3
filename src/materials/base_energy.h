#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "materials/energy_table.h"
#include "materials/roughness.h"
#include "textures/texture_input.h"

namespace candela {

/// Burley's ratio of the roughness along and across the brushing, for an anisotropy from 0 to 1.
Ggx Brushed(float alpha, float anisotropy);

/// What the base of a `principled` surface gives back of the light from each direction. Where it is
/// brushed, and textures say how much or how rough it is, it has a table for each of a grid of
/// surfaces, and blends them in between: all that is said of their energies is linear in them, so
/// what the blend says to be missing is what the added term gives back.
class BaseEnergy {
 public:
  BaseEnergy(const Roughness& roughness, const NumberInput& anisotropy,
             const EnergyTable::Facet& facet);

  /// Where a surface stands: the row of the only table, or the place in the grid.
  struct Place {
    float row, brushing;
  };
  Place PlaceOf(float alpha, float anisotropy) const;

  /// The row of its tables for light from `w`, by the azimuth where the surface is brushed.
  float RowOf(const Place& place, Vec3 w) const {
    if (!is_brushed_) return place.row;
    return EnergyTable::NearRowOfAzimuth(w) * rows_per_azimuth_row_;
  }

  /// See `EnergyTable`; `row` is what `RowOf` gave.
  float At(const Place& place, float cosine, float row) const {
    return Blend(place, [&](size_t i) { return tables_[i].At(cosine, row); });
  }
  float Mean(const Place& place) const;
  Vec3 SampleMissing(const Place& place, Vec2 u) const;
  float MissingPdf(const Place& place, float cosine) const;

  /// The means of the product with each row of `above`, for each row of the only table or for each
  /// table, and one of them for a place.
  std::vector<float> MeansOfProduct(const EnergyTable& above) const;
  float MeanOfProduct(std::span<const float> means, const Place& place, float row_above) const;

 private:
  /// Up to four tables around a place.
  struct Corners {
    size_t index[4];
    float weight[4];
  };
  Corners CornersOf(const Place& place) const;
  float RowOfMean(const Place& place) const { return tables_.size() == 1 ? place.row : 0; }

  /// A number that each table says, at a place.
  template <class Value>
  float Blend(const Place& place, const Value& value) const {
    if (tables_.size() == 1) return value(0);
    const Corners corners = CornersOf(place);
    float sum = 0;
    for (int i = 0; i < 4; ++i) {
      if (corners.weight[i] > 0) sum += corners.weight[i] * value(corners.index[i]);
    }
    return sum;
  }

  bool is_brushed_;
  float rows_per_azimuth_row_ = 1;
  size_t roughnesses_ = 1, brushings_ = 1;  ///< The grid.
  std::vector<EnergyTable> tables_;         ///< Those of all brushings for each roughness.
};

}  // namespace candela
