#pragma once

#include <algorithm>
#include <limits>

#include "math/vec.h"

namespace candela::kernel {

/// A ray in double, beside whose own rounding that of hits is large.
struct PreciseRay {
  Vec3d origin, direction;
  double t_min = 0;
  /// How far beside the ray, in each coordinate, the things may lie that it hits by the rounding of
  /// their tests in single precision.
  double rounding = 0;

  /// `rounding` of a ray when no coordinate of its origin and of what it is tested with is larger
  /// than 1. More than the kernel's boxes allow for; see docs/kernel.md.
  static constexpr double kRounding = 2e-6;
  /// That of the tiniest numbers, of coordinates and of t.
  static constexpr double kLeastRounding = std::numeric_limits<float>::min();

  static double RoundingOf(double farthest) { return kRounding * farthest + kLeastRounding; }

  /// Where the ray enters a box, at t_min at least; infinite when it misses it. A ray that touches
  /// the box enters it.
  double Enter(Vec3d low, Vec3d high) const {
    constexpr double kMiss = std::numeric_limits<double>::infinity();
    double enter = t_min, leave = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
      const double to_low = low[axis] - origin[axis], to_high = high[axis] - origin[axis];
      const double d = direction[axis];
      if (d == 0) {
        if (to_low > 0 || to_high < 0) return kMiss;
        continue;
      }
      enter = std::max(enter, (d > 0 ? to_low : to_high) / d);
      leave = std::min(leave, (d > 0 ? to_high : to_low) / d);
    }
    return enter <= leave ? enter : kMiss;
  }
};

}  // namespace candela::kernel
