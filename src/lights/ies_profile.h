#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec.h"
#include "sampling/distribution.h"

namespace candela {

/// How bright a lamp is in each direction, as goniometers measure it: a table of intensities over
/// vertical angles, from 0 straight down to 180 straight up, and horizontal ones around. Between
/// them it is linear in both angles, and 0 above the last and below the first vertical one.
/// Directions are those of a frame whose z axis points down, whose x axis is at the horizontal
/// angle of 0 and whose y axis at 90. Immutable; called concurrently.
class IesProfile {
 public:
  /// Angles are in degrees and grow strictly. There are two vertical ones at least, in [0, 180],
  /// and two horizontal ones, of which the first is 0 and the last 360. Intensities are finite and
  /// not negative: for each horizontal angle those of all vertical ones.
  struct Table {
    std::vector<float> vertical, horizontal, candela;
    float first_horizontal = 0;  ///< The one of the lamp that the list calls 0; from 0 to 360.
  };
  explicit IesProfile(Table table);

  /// In candela, towards a unit direction.
  float Intensity(Vec3 w) const;
  /// The integral of it over all directions, in lumen.
  double Flux() const { return flux_; }
  /// The cosine of the largest vertical angle that the table has.
  float LeastCosine() const { return static_cast<float>(cosines_.back()); }
  float MostCosine() const { return static_cast<float>(cosines_.front()); }

  /// A unit direction, drawn after the intensity with two numbers in [0, 1), and its density over
  /// solid angle.
  struct Sample {
    Vec3 w;
    float pdf;
  };
  Sample Draw(Vec2 u) const;
  /// 0 where it draws nothing.
  float Pdf(Vec3 w) const;

 private:
  /// A cell of the table, between two angles each, and a place in it.
  struct Cell {
    size_t row, column;
    double down, around;  ///< Vertical and horizontal angle from the first of the cell, in [0, 1].
    bool is_inside;       ///< False where the table says nothing.
  };
  Cell CellOf(Vec3 w) const;
  double At(size_t row, size_t column) const {
    return double{table_.candela[column * table_.vertical.size() + row]};
  }
  size_t Rows() const { return table_.vertical.size() - 1; }
  size_t Columns() const { return table_.horizontal.size() - 1; }
  /// The fluxes of cells, row after row.
  std::vector<float> Fluxes();
  /// What turns a density over the unit square, in which all cells are alike, into one over solid
  /// angle.
  double DensityScale(size_t row, size_t column) const;

  Table table_;
  std::vector<double> cosines_;  ///< Of the vertical angles.
  double flux_ = 0;
  Distribution2D distribution_;  ///< Of emission, constant on each cell.
};

}  // namespace candela
