#include "scene/fog.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

// Over so small a part of the fog's height the density is that of the middle, to the square of the
// part; beyond, the difference of two columns keeps ten digits.
constexpr double kLevel = 1e-6;

}  // namespace

float Fog::Transmittance(Vec3 origin, Vec3 direction, double distance) const {
  return static_cast<float>(Exp(-OpticalDepth(origin, direction, distance)));
}

double Fog::OpticalDepth(Vec3 origin, Vec3 direction, double distance) const {
  if (spec_.density == 0 || distance == 0) return 0;
  if (spec_.profile == FogSpec::Profile::kHomogeneous) return double{spec_.density} * distance;

  const auto y = double{origin.y}, slope = double{direction.y};
  const double rise = slope == 0 ? 0 : slope * distance;  // Level rays may be endless.
  if (std::abs(rise) <= kLevel * double{spec_.height}) {
    const double density = DensityAt(y + rise / 2);
    return density == 0 ? 0 : density * distance;
  }
  const double depth = std::abs((ColumnAbove(y) - ColumnAbove(y + rise)) / slope);
  // Both are infinite, far below where there is nothing but fog.
  return std::isnan(depth) ? kEndless : depth;
}

double Fog::DensityAt(double y) const {
  const double above = (y - double{spec_.base}) / double{spec_.height};
  if (spec_.profile == FogSpec::Profile::kExponential) return double{spec_.density} * Exp(-above);
  return double{spec_.density} * std::clamp(1 - above, 0.0, 1.0);
}

double Fog::ColumnAbove(double y) const {
  const double above = (y - double{spec_.base}) / double{spec_.height};
  const double scale = double{spec_.density} * double{spec_.height};
  if (spec_.profile == FogSpec::Profile::kExponential) return scale * Exp(-above);
  // A ramp on top of what is evenly dense.
  const double in_ramp = std::clamp(1 - above, 0.0, 1.0);
  return scale * (in_ramp * in_ramp / 2 + std::max(0.0, -above));
}

}  // namespace candela
