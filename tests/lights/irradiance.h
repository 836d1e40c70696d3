#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "lights/light.h"
#include "sampling/sampler.h"
#include "tests/sampling/chi_square.h"

namespace candela::test {

/// What a light gives to a surface at `p` with the unit normal `n`, in red, if nothing is in the
/// way.
struct Irradiance {
  double mean;
  double error;  ///< Standard error, from runs that do not depend on each other.
};

/// Estimated as a path does: radiance times cosine over density, for light from above the surface.
inline Irradiance IrradianceOf(const Light& light, Vec3 p, Vec3 n, uint32_t samples = 16384) {
  constexpr uint32_t kRuns = 32;
  double sum = 0, squares = 0;
  for (uint32_t run = 0; run < kRuns; ++run) {
    double mean = 0;
    for (uint32_t i = 0; i < samples; ++i) {
      const Vec2 u = Sampler(1, run, 0, i).Get2D(0);
      const LightSample sample = light.SampleIncident(p, u);
      const float cosine = Dot(n, sample.direction);
      if (sample.pdf == 0 || !(cosine > 0)) continue;
      mean += static_cast<double>(sample.radiance[0]) * static_cast<double>(cosine) /
              static_cast<double>(sample.pdf) / samples;
    }
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / kRuns;
  const double variance = std::max(0.0, squares / kRuns - mean * mean) / (kRuns - 1);
  return {mean, std::sqrt(variance)};
}

/// The mean is the expected one by 4.7 standard errors, and these are at most 0.1 percent of it.
/// Single precision is let through.
inline void ExpectIrradiance(const Light& light, Vec3 p, Vec3 n, double expected) {
  const Irradiance e = IrradianceOf(light, p, n);
  EXPECT_LE(std::abs(e.mean - expected), kLargestDeviate * e.error + 3e-6 * expected);
  EXPECT_LE(e.error, 1e-3 * expected);
}

}  // namespace candela::test
