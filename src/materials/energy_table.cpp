#include "materials/energy_table.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "materials/table_place.h"
#include "math/elementary.h"

namespace candela {
namespace {

// The columns stand at the squares of 0, 1/31, ... 1: close to each other at the horizon, where the
// share changes fast.
constexpr int kColumns = 32;
constexpr float kNearestToHorizon = 1e-4f;
constexpr int kRoughnessRows = 32;
constexpr int kIntervals = kColumns - 1;

/// Where the integral over the facets that a direction sees is evaluated. The rings are crowded at
/// the end of the steep facets, which are few but lose most.
struct Points {
  int turns, rings;
};
constexpr int kStride = 7;  // Without a divisor in common with the turns.

constexpr Points PointsFor(EnergyTable::Detail detail) {
  switch (detail) {
    case EnergyTable::Detail::kSmooth:
      return {24, 32};
    case EnergyTable::Detail::kCoarse:
      return {16, 20};
    case EnergyTable::Detail::kEdge:
      return {48, 64};
  }
  return {};
}

size_t CellOf(int row, int column) {
  return static_cast<size_t>(row) * kColumns + static_cast<size_t>(column);
}

float Column(float cosine) {
  return std::sqrt(cosine) * (kColumns - 1);
}

float Blend(float a, float b, float t) {
  return a * (1 - t) + b * t;
}

/// Replaces each row by the integral over the azimuth, of rows that are blended in between.
void AverageRows(std::vector<float>* values, size_t columns) {
  const size_t rows = values->size() / columns;
  for (size_t column = 0; column < columns; ++column) {
    double sum = 0;
    for (size_t row = 0; row < rows; ++row) {
      const bool is_end = row == 0 || row + 1 == rows;
      sum += (is_end ? 0.5 : 1.0) * double{(*values)[row * columns + column]};
    }
    const auto mean = static_cast<float>(sum / static_cast<double>(rows - 1));
    for (size_t row = 0; row < rows; ++row) (*values)[row * columns + column] = mean;
  }
}

/// The square of the cosine at a column, and how much of it lies between that and the next: as much
/// as of the projected area, over pi.
float SquareAt(int column) {
  const float root = static_cast<float>(column) / kIntervals;
  return root * root * root * root;
}
float SquaresBetween(int column) {
  return SquareAt(column + 1) - SquareAt(column);
}

/// The mean, weighted by the cosine, of a polynomial of degree 1 or 2 in the root of the cosine
/// between each two columns. With the weight it has a degree of at most 5, where three points of
/// Gauss give the exact integral.
template <class Function>
double CosineMean(const Function& function) {
  constexpr double kNodes[] = {-0.7745966692414834, 0, 0.7745966692414834};
  constexpr double kWeights[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  double sum = 0;
  for (int interval = 0; interval < kIntervals; ++interval) {
    for (int i = 0; i < 3; ++i) {
      const double root = (interval + 0.5 + 0.5 * kNodes[i]) / kIntervals;
      const double value = function(static_cast<float>(root * root));
      sum += kWeights[i] * 2 * root * root * root * value / kIntervals;
    }
  }
  return sum;
}

float ShareOf(const Ggx& surface, Vec3 wo, const EnergyTable::Facet& facet, Points points) {
  const auto turns = static_cast<float>(points.turns), rings = static_cast<float>(points.rings);
  double sum = 0, weights = 0;
  for (int ring = 0; ring < points.rings; ++ring) {
    for (int turn = 0; turn < points.turns; ++turn) {
      // Each point has a distance and an azimuth that no other has, so that edges of what a facet
      // gives back do not fall between two rings or two spokes.
      const float within = (static_cast<float>(turn * kStride % points.turns) + 0.5f) / turns;
      const float s = (static_cast<float>(ring) + within) / rings;
      const float at = static_cast<float>(turn) + (static_cast<float>(ring) + 0.5f) / rings;
      const Vec3 m = surface.SampleVisible(wo, {at / turns, 1 - s * s * s});
      const double weight = double{s} * double{s};
      sum += weight * double{facet(surface, wo, m)};
      weights += weight;
    }
  }
  return static_cast<float>(std::min(sum / weights, 1.0));
}

}  // namespace

EnergyTable::EnergyTable(int rows) : rows_(rows), shares_(static_cast<size_t>(rows) * kColumns) {}

EnergyTable EnergyTable::OfRoughness(float alpha, const Facet& facet, Detail detail) {
  EnergyTable table(1);
  table.FillRow(0, {alpha, alpha}, 0, facet, detail);
  table.Summarise();
  return table;
}

EnergyTable EnergyTable::OfAllRoughness(const Facet& facet, Detail detail) {
  EnergyTable table(kRoughnessRows);
  ParallelFor(kRoughnessRows, [&](int64_t row) {
    const float root = static_cast<float>(row) / (kRoughnessRows - 1);
    const float alpha = std::max(root * root, kSmoothestAlpha);
    table.FillRow(static_cast<int>(row), {alpha, alpha}, 0, facet, detail);
  });
  table.Summarise();
  return table;
}

EnergyTable EnergyTable::OfAnisotropic(const Ggx& surface, const Facet& facet, Detail detail,
                                       int rows) {
  EnergyTable table(rows);
  ParallelFor(rows, [&](int64_t row) {
    const float quarters = static_cast<float>(row) / static_cast<float>(rows - 1);
    table.FillRow(static_cast<int>(row), surface, static_cast<float>(kPi / 2) * quarters, facet,
                  detail);
  });
  table.Summarise();
  // Light from everywhere comes from all azimuths.
  AverageRows(&table.means_, 1);
  AverageRows(&table.missing_, kColumns);
  return table;
}

float EnergyTable::RowOfRoughness(float alpha) {
  return std::sqrt(alpha) * (kRoughnessRows - 1);
}

float EnergyTable::RowOfAzimuth(Vec3 w) {
  const float quarter = static_cast<float>(kPi / 2);
  return Atan2(std::abs(w.y), std::abs(w.x)) / quarter * (kAzimuthRows - 1);
}

// The arc tangent by a polynomial of Hastings, "Approximations for Digital Computers", 1955.
float EnergyTable::NearRowOfAzimuth(Vec3 w) {
  const float x = std::abs(w.x), y = std::abs(w.y);
  const float larger = std::max(x, y);
  const float q = larger > 0 ? std::min(x, y) / larger : 0, q2 = q * q;
  const float angle =
      q *
      (0.9998660f + q2 * (-0.3302995f + q2 * (0.1801410f + q2 * (-0.0851330f + q2 * 0.0208351f))));
  constexpr auto kRowsPerRadian = static_cast<float>((kAzimuthRows - 1) / (kPi / 2));
  const float row = angle * kRowsPerRadian;
  return y > x ? (kAzimuthRows - 1) - row : row;
}

void EnergyTable::FillRow(int row, const Ggx& surface, float azimuth, const Facet& facet,
                          Detail detail) {
  const float c = Cos(azimuth), s = Sin(azimuth);
  for (int column = 0; column < kColumns; ++column) {
    const float root = static_cast<float>(column) / kIntervals;
    const float cosine = std::max(root * root, kNearestToHorizon);
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    shares_[CellOf(row, column)] =
        ShareOf(surface, {sine * c, sine * s, cosine}, facet, PointsFor(detail));
  }
}

void EnergyTable::Summarise() {
  // The mean is that of the blended shares rather than of the true ones: with it the added term
  // gives back exactly what the table says to be missing.
  for (int row = 0; row < rows_; ++row) {
    double area = 0;
    const double missing =
        CosineMean([&](float cosine) { return 1 - double{At(cosine, static_cast<float>(row))}; });
    means_.push_back(static_cast<float>(1 - missing));

    // Directions are drawn by straight lines in the square of the cosine instead.
    const float* shares = &shares_[CellOf(row, 0)];
    for (int i = 0; i < kIntervals; ++i) {
      area += (2 - double{shares[i]} - double{shares[i + 1]}) / 2 * SquaresBetween(i);
    }
    for (int i = 0; i < kColumns; ++i) {
      missing_.push_back(static_cast<float>(area > 0 ? (1 - double{shares[i]}) / area : 1));
    }
  }
}

float EnergyTable::At(float cosine, float row) const {
  const TablePlace x(Column(cosine), kColumns), y(row, rows_);
  const float* here = &shares_[CellOf(y.index, x.index)];
  const float lower = Blend(here[0], here[1], x.part);
  if (y.part == 0) return lower;
  return Blend(lower, Blend(here[kColumns], here[kColumns + 1], x.part), y.part);
}

float EnergyTable::Mean(float row) const {
  const TablePlace y(row, rows_);
  const float* here = &means_[static_cast<size_t>(y.index)];
  return y.part == 0 ? here[0] : Blend(here[0], here[1], y.part);
}

float EnergyTable::MeanOfProduct(const EnergyTable& first, int first_row, int rows,
                                 const EnergyTable& second, int second_row) {
  return static_cast<float>(CosineMean([&](float cosine) {
    double sum = 0, weights = 0;
    for (int i = 0; i < rows; ++i) {
      const double weight = i == 0 || i + 1 == rows ? 0.5 : 1;
      sum += weight * double{first.At(cosine, static_cast<float>(first_row + i))};
      weights += weight;
    }
    return sum / weights * double{second.At(cosine, static_cast<float>(second_row))};
  }));
}

float EnergyTable::MissingAt(int column, float row) const {
  const TablePlace y(row, rows_);
  const float* here = &missing_[CellOf(y.index, column)];
  return y.part == 0 ? here[0] : Blend(here[0], here[kColumns], y.part);
}

Vec3 EnergyTable::SampleMissing(float row, Vec2 u) const {
  // The interval whose part of the sum contains u.y.
  int interval = 0;
  float left = u.y, a = MissingAt(0, row), b = MissingAt(1, row);
  float probability = (a + b) / 2 * SquaresBetween(0);
  while (left >= probability && interval + 1 < kIntervals) {
    left -= probability;
    ++interval;
    a = b;
    b = MissingAt(interval + 1, row);
    probability = (a + b) / 2 * SquaresBetween(interval);
  }
  // Within it the density goes from a to b in a straight line.
  const float part = probability > 0 ? std::min(left / probability, 1.0f) : 0;
  const float root = std::sqrt(Blend(a * a, b * b, part));
  const float t = a + root > 0 ? std::min(part * (a + b) / (a + root), 1.0f) : part;
  const float square = std::min(SquareAt(interval) + t * SquaresBetween(interval), 1.0f);
  const float sine = std::sqrt(1 - square);
  const float phi = static_cast<float>(2 * kPi) * u.x;
  return {sine * Cos(phi), sine * Sin(phi), std::sqrt(square)};
}

float EnergyTable::MissingPdf(float cosine, float row) const {
  const int interval = TablePlace(Column(cosine), kColumns).index;
  const float t = (cosine * cosine - SquareAt(interval)) / SquaresBetween(interval);
  const float density =
      Blend(MissingAt(interval, row), MissingAt(interval + 1, row), std::clamp(t, 0.0f, 1.0f));
  return density * cosine * static_cast<float>(1 / kPi);
}

float MirrorFacet(const Ggx& surface, Vec3 wo, Vec3 m) {
  const Vec3 wi = m * (2 * Dot(wo, m)) - wo;
  if (!(wi.z > 0)) return 0;
  return surface.MaskingAndShadowing(wo, wi) / surface.Masking(wo);
}

}  // namespace candela
