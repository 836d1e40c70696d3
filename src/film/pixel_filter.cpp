#include "film/pixel_filter.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "math/elementary.h"

namespace candela {
namespace {

double Box(double) {
  return 1;
}

double Tent(double x) {
  return 1 - x;
}

/// A normal distribution of deviation 1/2, cut off at three deviations.
double Gaussian(double x) {
  return Exp(-2 * x * x);
}

/// The piecewise cubic with B = C = 1/3 of D. Mitchell and A. Netravali, "Reconstruction filters in
/// computer graphics" (1988), times 18.
double Mitchell(double x) {
  if (x < 1) return (21 * x - 36) * x * x + 16;
  return ((-7 * x + 36) * x - 60) * x + 32;
}

/// The window of four terms of F. Harris, "On the use of windows for harmonic analysis with the
/// discrete Fourier transform" (1978), as wide as renderers make it.
double BlackmanHarris(double x) {
  const double degrees = 120 * x;  // Half a turn at the radius.
  return 0.35875 + 0.48829 * CosDegrees(degrees) + 0.14128 * CosDegrees(2 * degrees) +
         0.01168 * CosDegrees(3 * degrees);
}

constexpr PixelFilterEntry kFilters[] = {
    {"box", "the mean over the square of the pixel", 0.5f, Box},
    {"tent", "falls off linearly to the centres of the neighbours", 1, Tent},
    {"gaussian", "soft, without ringing (deviation 0.5)", 1.5f, Gaussian},
    {"blackman_harris", "soft, and dies away smoothly", 1.5f, BlackmanHarris},
    {"mitchell", "sharper, with slightly negative sides (B = C = 1/3)", 2, Mitchell},
};

// Even, so that a node lies in the centre; the polyline is then within 3e-5 of the curved profiles.
constexpr int kCells = 512;

}  // namespace

std::span<const PixelFilterEntry> PixelFilters() {
  return kFilters;
}

const PixelFilterEntry* FindPixelFilter(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kFilters), std::end(kFilters),
                   [&](const PixelFilterEntry& entry) { return entry.name == name; });
  return found == std::end(kFilters) ? nullptr : found;
}

PixelFilter::PixelFilter(const PixelFilterEntry& entry)
    : radius_(entry.radius), step_(2 * radius_ / kCells) {
  CHECK(entry.radius > 0);
  const auto profile = [&](double node) {
    return entry.profile(std::min(std::abs(node - kCells / 2) * step_, radius_));
  };
  for (int i = 0; i <= kCells; ++i) magnitude_.push_back(std::abs(profile(i)));

  double signed_integral = 0;
  integral_.push_back(0);
  for (size_t i = 0; i < kCells; ++i) {
    const double area = 0.5 * (magnitude_[i] + magnitude_[i + 1]);
    sign_.push_back(profile(static_cast<double>(i) + 0.5) < 0 ? -1 : 1);
    integral_.push_back(integral_.back() + area);
    signed_integral += sign_.back() * area;
  }
  const double total = integral_.back();
  for (double& value : integral_) value /= total;
  for (double& value : magnitude_) value /= total;
  weight_ = total / signed_integral;

  uint16_t cell = 0;
  for (int i = 0; i < kCells; ++i) {
    while (integral_[cell + 1u] <= static_cast<double>(i) / kCells) ++cell;
    guide_.push_back(cell);
  }
}

PixelFilter::AxisSample PixelFilter::SampleAxis(float u) const {
  // The guide gives a cell at or a little before the one that holds u.
  size_t cell = guide_[static_cast<size_t>(u * kCells)];
  while (cell + 1 < kCells && integral_[cell + 1] <= static_cast<double>(u)) ++cell;

  // Within the cell the magnitude runs from a to b, so its integral is a t + (b - a) t^2 / 2. This
  // form of the root of the quadratic does not cancel.
  const double a = magnitude_[cell];
  const double b = magnitude_[cell + 1];
  const double area = static_cast<double>(u) - integral_[cell];
  const double divisor = a + std::sqrt(std::max(0.0, a * a + 2 * (b - a) * area));
  const double t = divisor > 0 ? std::min(2 * area / divisor, 1.0) : 0;
  return {(static_cast<double>(cell) + t) * step_ - radius_, sign_[cell] * weight_};
}

double PixelFilter::AxisAt(float offset) const {
  const double cells = (double{offset} + radius_) / step_;
  if (!(cells >= 0 && cells < kCells)) return 0;
  const auto cell = static_cast<size_t>(cells);
  const double t = cells - static_cast<double>(cell);
  const double height = magnitude_[cell] * (1 - t) + magnitude_[cell + 1] * t;
  return sign_[cell] * weight_ * height / step_;
}

float PixelFilter::At(Vec2 offset) const {
  return static_cast<float>(AxisAt(offset.x) * AxisAt(offset.y));
}

FilterSample PixelFilter::Sample(Vec2 u) const {
  const AxisSample x = SampleAxis(u.x);
  const AxisSample y = SampleAxis(u.y);
  return {{static_cast<float>(x.offset), static_cast<float>(y.offset)},
          static_cast<float>(x.weight * y.weight)};
}

}  // namespace candela
