#pragma once

#include <functional>
#include <vector>

#include "materials/ggx.h"

namespace candela {

/// What a rough surface gives back of the light from one direction, when each ray meets one facet:
/// the rest would meet more of them, and is added by a term of its own, so that no energy is lost:
/// Kulla and Conty, "Revisiting Physically Based Shading at Imageworks", 2017. A row for each
/// roughness, or for each azimuth of an anisotropic surface.
class EnergyTable {
 public:
  /// What a facet with the normal `m` gives back of the light from `wo`, over what it gets.
  using Facet = std::function<float(const Ggx& surface, Vec3 wo, Vec3 m)>;

  /// How fast what a facet gives back changes with its normal.
  enum class Detail {
    kSmooth,  ///< As of a mirror or a coat,
    kCoarse,  ///< or of those, where there are many tables, within half a per cent.
    kEdge,    ///< As of glass, which reflects everything from some angle on.
  };

  /// One row: a surface of the same roughness in all directions.
  static EnergyTable OfRoughness(float alpha, const Facet& facet, Detail detail);

  /// A row for each roughness from 0 to 1; see `RowOfRoughness`.
  static EnergyTable OfAllRoughness(const Facet& facet, Detail detail);

  /// Rows for an anisotropic surface, by azimuth; see `RowOfAzimuth`, whose rows are multiplied by
  /// `AzimuthScale` where there are not as many as there are by default.
  static EnergyTable OfAnisotropic(const Ggx& surface, const Facet& facet,
                                   Detail detail = Detail::kSmooth, int rows = kAzimuthRows);
  static constexpr float AzimuthScale(int rows) {
    return static_cast<float>(rows - 1) / (kAzimuthRows - 1);
  }

  /// The row that stands for a roughness, and for the azimuth of a direction.
  static float RowOfRoughness(float alpha);
  static float RowOfAzimuth(Vec3 w);
  /// The same within 1e-4 rows, in a third of the time.
  static float NearRowOfAzimuth(Vec3 w);

  /// The share for light at the given cosine to the normal, above 0.
  float At(float cosine, float row) const;
  /// The same for light from everywhere.
  float Mean(float row) const;

  int RowCount() const { return rows_; }

  /// The mean over light from everywhere of the product of what two surfaces give back: of the mean
  /// of `rows` rows of the first one, evenly spaced with half of the weight at the ends, and of a
  /// row of the second.
  static float MeanOfProduct(const EnergyTable& first, int first_row, int rows,
                             const EnergyTable& second, int second_row);

  /// A direction of the upper hemisphere, nearly in proportion to what is missing there and the
  /// cosine, and its density per steradian.
  Vec3 SampleMissing(float row, Vec2 u) const;
  float MissingPdf(float cosine, float row) const;

 private:
  static constexpr int kAzimuthRows = 17;

  explicit EnergyTable(int rows);
  void FillRow(int row, const Ggx& surface, float azimuth, const Facet& facet, Detail detail);
  void Summarise();
  float MissingAt(int column, float row) const;

  int rows_;
  std::vector<float> shares_;   ///< Row after row.
  std::vector<float> means_;    ///< Of each row.
  std::vector<float> missing_;  ///< Row after row: densities over the square of the cosine.
};

/// A facet of a mirror, which loses nothing: what is missing goes below the horizon.
float MirrorFacet(const Ggx& surface, Vec3 wo, Vec3 m);

}  // namespace candela
