#pragma once

#include <optional>
#include <vector>

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

  /// For a surface that is brushed the same everywhere.
  PrincipledLayers(float ior, const Ggx& brushed, float rotation_degrees);
  /// For all others. Where a texture says how it is brushed, the tables are those of a surface that
  /// is in all directions as smooth as in its smoothest: some light is lost.
  PrincipledLayers(float ior, const Roughness& roughness, bool is_brushing_textured,
                   float rotation_degrees);

  /// What the parts below ask for; to be called before these are used.
  void AddCoat(const Roughness& roughness);
  void AddSheen() { sheen = &SheenTable::Get(); }

  /// The row of the tables of the base that stands for its surface; brushed ones the same
  /// everywhere have one for each direction.
  float RowOf(const Ggx& at) const;
  float RowOf(float row, Vec3 w) const {
    return is_row_by_azimuth ? EnergyTable::NearRowOfAzimuth(w) : row;
  }

  /// The mean, weighted by the cosine, of what the coat times the dielectric base below reflects.
  float MeanProduct(float row, float coat_row) const;

  float eta;                         ///< The refractive index of the dielectric part.
  float cos_rotation, sin_rotation;  ///< Of the brushing, in the frame.
  bool is_row_by_azimuth;
  EnergyTable dielectric, metal;
  std::optional<EnergyTable> coat;
  const SheenTable* sheen = nullptr;

 private:
  bool is_row_by_roughness_;
  std::vector<float> mean_products_;  ///< Of each row of the base all rows of the coat.
};

}  // namespace candela
