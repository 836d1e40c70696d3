#include "sampling/distribution.h"

#include <algorithm>

#include "base/check.h"

namespace candela {
namespace {

/// Just below 1.
constexpr float kLast = 0x1.fffffep-1f;

/// Stores the sums of the first 0, 1, 2, ... values as parts of the whole, which is returned. Each
/// is rounded once: what counts as density later is the difference of two of them, so that drawing
/// and density agree to the last bit.
double Accumulate(std::span<const float> values, std::span<float> cumulative) {
  double sum = 0;
  for (const float value : values) sum += value;
  double so_far = 0;
  cumulative[0] = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    so_far += sum > 0 ? values[i] / sum : 1.0 / static_cast<double>(values.size());
    cumulative[i + 1] = std::min(static_cast<float>(so_far), 1.0f);
  }
  // Rounding must not leave a gap behind the last interval that has a share.
  const float reached = cumulative.back();
  for (size_t i = values.size(); i > 0 && cumulative[i] == reached; --i) cumulative[i] = 1;
  return sum;
}

/// The interval in which the cumulative function passes `u`; it has a share.
size_t FindInterval(std::span<const float> cumulative, float u) {
  const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, u);
  return static_cast<size_t>(above - cumulative.begin()) - 1;
}

Distribution1D::Sample DrawFrom(std::span<const float> cumulative, float u) {
  const size_t i = FindInterval(cumulative, u);
  const auto n = static_cast<float>(cumulative.size() - 1);
  const float share = cumulative[i + 1] - cumulative[i];
  const float within = std::min((u - cumulative[i]) / share, kLast);
  const float position = (static_cast<float>(i) + within) / n;
  return {std::min(position, kLast), share * n, i};
}

/// The interval that holds a position.
size_t IntervalOf(float position, size_t count) {
  const float scaled = std::max(position, 0.0f) * static_cast<float>(count);
  return std::min(static_cast<size_t>(scaled), count - 1);
}

float PdfOf(std::span<const float> cumulative, float position) {
  const size_t n = cumulative.size() - 1;
  const size_t i = IntervalOf(position, n);
  return (cumulative[i + 1] - cumulative[i]) * static_cast<float>(n);
}

float InvertIn(std::span<const float> cumulative, float position) {
  const size_t n = cumulative.size() - 1;
  const size_t i = IntervalOf(position, n);
  const float within = position * static_cast<float>(n) - static_cast<float>(i);
  return cumulative[i] + within * (cumulative[i + 1] - cumulative[i]);
}

std::vector<float> SumsOfRows(std::span<const float> values, size_t columns,
                              std::vector<float>* cumulative) {
  CHECK(columns > 0 && !values.empty() && values.size() % columns == 0);
  const size_t rows = values.size() / columns;
  cumulative->resize(rows * (columns + 1));
  std::vector<float> sums(rows);
  for (size_t row = 0; row < rows; ++row) {
    const auto target = std::span(*cumulative).subspan(row * (columns + 1), columns + 1);
    const double sum = Accumulate(values.subspan(row * columns, columns), target);
    sums[row] = static_cast<float>(sum / static_cast<double>(columns));
  }
  return sums;
}

}  // namespace

Distribution1D::Distribution1D(std::span<const float> values) : cumulative_(values.size() + 1) {
  CHECK(!values.empty());
  Accumulate(values, cumulative_);
}

Distribution1D::Sample Distribution1D::Draw(float u) const {
  return DrawFrom(cumulative_, u);
}

float Distribution1D::Pdf(float position) const {
  return PdfOf(cumulative_, position);
}

float Distribution1D::Invert(float position) const {
  return InvertIn(cumulative_, position);
}

Distribution2D::Distribution2D(std::span<const float> values, size_t columns)
    : columns_(columns), rows_(SumsOfRows(values, columns, &cumulative_)) {}

Distribution2D::Sample Distribution2D::Draw(Vec2 u) const {
  const Distribution1D::Sample y = rows_.Draw(u.y);
  const Distribution1D::Sample x = DrawFrom(Row(y.interval), u.x);
  return {{x.position, y.position}, x.pdf * y.pdf};
}

float Distribution2D::Pdf(Vec2 position) const {
  const size_t row = IntervalOf(position.y, rows_.size());
  return rows_.Pdf(position.y) * PdfOf(Row(row), position.x);
}

Vec2 Distribution2D::Invert(Vec2 position) const {
  const size_t row = IntervalOf(position.y, rows_.size());
  return {InvertIn(Row(row), position.x), rows_.Invert(position.y)};
}

}  // namespace candela
