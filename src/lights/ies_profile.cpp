#include "lights/ies_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kRadian = kPi / 180;

/// The interval of an ascending list in which a value lies, the last of them for its end.
size_t IntervalOf(const std::vector<float>& list, double value) {
  const auto above = std::upper_bound(list.begin() + 1, list.end() - 1, value,
                                      [](double x, float element) { return x < double{element}; });
  return static_cast<size_t>(above - list.begin()) - 1;
}

double Part(double value, float first, float last) {
  return std::clamp((value - double{first}) / (double{last} - double{first}), 0.0, 1.0);
}

std::vector<double> CosinesOf(const std::vector<float>& degrees) {
  std::vector<double> cosines;
  for (const float angle : degrees) cosines.push_back(CosDegrees(double{angle}));
  return cosines;
}

}  // namespace

IesProfile::IesProfile(Table table)
    : table_(std::move(table)),
      cosines_(CosinesOf(table_.vertical)),
      distribution_(Fluxes(), Columns()) {}

// In a cell the mean over the horizontal angles is linear in the vertical one, t, from a to b: the
// integral of (p + q (t - a)) sin t is p (cos a - cos b) + q (sin b - sin a - (b - a) cos b).
std::vector<float> IesProfile::Fluxes() {
  std::vector<float> fluxes;
  fluxes.reserve(Rows() * Columns());
  for (size_t row = 0; row < Rows(); ++row) {
    const double a = double{table_.vertical[row]}, b = double{table_.vertical[row + 1]};
    const double height = cosines_[row] - cosines_[row + 1];
    const double moment = SinDegrees(b) - SinDegrees(a) - (b - a) * kRadian * cosines_[row + 1];
    for (size_t column = 0; column < Columns(); ++column) {
      const double around =
          (double{table_.horizontal[column + 1]} - double{table_.horizontal[column]}) * kRadian;
      const double first = (At(row, column) + At(row, column + 1)) / 2;
      const double last = (At(row + 1, column) + At(row + 1, column + 1)) / 2;
      const double slope = (last - first) / ((b - a) * kRadian);
      const double flux = std::max(0.0, around * (first * height + slope * moment));
      flux_ += flux;
      fluxes.push_back(static_cast<float>(flux));
    }
  }
  return fluxes;
}

IesProfile::Cell IesProfile::CellOf(Vec3 w) const {
  const double level = std::sqrt(double{w.x} * double{w.x} + double{w.y} * double{w.y});
  const double vertical = Atan2(level, double{w.z}) / kRadian;
  double horizontal = level > 0 ? Atan2(double{w.y}, double{w.x}) / kRadian : 0;
  horizontal -= double{table_.first_horizontal};
  if (horizontal < 0) horizontal += 360;
  if (horizontal < 0) horizontal += 360;  // Both angles may have been on the far side.
  Cell cell;
  cell.row = IntervalOf(table_.vertical, vertical);
  cell.column = IntervalOf(table_.horizontal, horizontal);
  cell.down = Part(vertical, table_.vertical[cell.row], table_.vertical[cell.row + 1]);
  cell.around =
      Part(horizontal, table_.horizontal[cell.column], table_.horizontal[cell.column + 1]);
  cell.is_inside =
      vertical >= double{table_.vertical.front()} && vertical <= double{table_.vertical.back()};
  return cell;
}

float IesProfile::Intensity(Vec3 w) const {
  const Cell cell = CellOf(w);
  if (!cell.is_inside) return 0;
  const auto at = [&](size_t row) {
    return At(row, cell.column) * (1 - cell.around) + At(row, cell.column + 1) * cell.around;
  };
  return static_cast<float>(at(cell.row) * (1 - cell.down) + at(cell.row + 1) * cell.down);
}

double IesProfile::DensityScale(size_t row, size_t column) const {
  const double around =
      (double{table_.horizontal[column + 1]} - double{table_.horizontal[column]}) * kRadian;
  const double height = cosines_[row] - cosines_[row + 1];
  return 1 / (around * height * static_cast<double>(Rows() * Columns()));
}

IesProfile::Sample IesProfile::Draw(Vec2 u) const {
  const Distribution2D::Sample drawn = distribution_.Draw(u);
  const auto cell = [](float position, size_t count) {
    const double at = double{position} * static_cast<double>(count);
    const size_t index = std::min(static_cast<size_t>(at), count - 1);
    return std::pair(index, at - static_cast<double>(index));
  };
  const auto [row, down] = cell(drawn.position.y, Rows());
  const auto [column, around] = cell(drawn.position.x, Columns());
  const double cosine = cosines_[row] + (cosines_[row + 1] - cosines_[row]) * down;
  const double first = double{table_.horizontal[column]};
  const double angle = double{table_.first_horizontal} + first +
                       (double{table_.horizontal[column + 1]} - first) * around;
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const Vec3d w{CosDegrees(angle) * sine, SinDegrees(angle) * sine, cosine};
  return {ToFloat(w), static_cast<float>(double{drawn.pdf} * DensityScale(row, column))};
}

float IesProfile::Pdf(Vec3 w) const {
  const Cell cell = CellOf(w);
  if (!cell.is_inside) return 0;
  const auto place = [](size_t index, size_t count) {
    return (static_cast<float>(index) + 0.5f) / static_cast<float>(count);
  };
  const float density = distribution_.Pdf({place(cell.column, Columns()), place(cell.row, Rows())});
  return static_cast<float>(double{density} * DensityScale(cell.row, cell.column));
}

}  // namespace candela
