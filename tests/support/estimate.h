#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "integrators/integrator.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/effort.h"

namespace candela::testing_support {

/// A mean with its standard error.
struct Estimate {
  double mean = 0;
  double error = 0;
};

/// The mean of the red radiance that `integrator` sees through image points; `point(i)` is that of
/// sample i, of so many as `Samples` makes of them. The samples of a pixel are spread evenly and
/// depend on each other, so the error is taken from many pixels that all look through the same
/// points.
template <class Point>
Estimate EstimateMean(const Integrator& integrator, Point point, uint32_t pixels,
                      uint32_t usual_samples) {
  const uint32_t samples = Samples(usual_samples);
  const auto workspace = integrator.MakeWorkspace();
  std::vector<SampleRequest> requests(samples);
  std::vector<Spectrum> radiance(samples);
  double sum = 0, squares = 0;
  for (uint32_t pixel = 0; pixel < pixels; ++pixel) {
    for (uint32_t i = 0; i < samples; ++i) requests[i] = {pixel, 0, i, point(i)};
    integrator.Trace(requests, workspace.get(), {radiance});
    double mean = 0;
    for (const Spectrum& value : radiance) mean += static_cast<double>(value[0]) / samples;
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / pixels;
  const double variance = std::max(0.0, squares / pixels - mean * mean) / (pixels - 1);
  return {mean, std::sqrt(variance)};
}

/// The red radiance through one image point.
inline Estimate EstimateRadiance(const Integrator& integrator, Vec2 image_point, uint32_t pixels,
                                 uint32_t samples) {
  return EstimateMean(
      integrator, [=](uint32_t) { return image_point; }, pixels, samples);
}

/// The mean is the expected one by 4.7 standard errors, and these are at most 0.1 percent of it, so
/// that a noisy estimate cannot pass by being noisy. Rounding of single precision is let through.
inline void ExpectEstimate(const Estimate& estimate, double expected) {
  EXPECT_LE(std::abs(estimate.mean - expected),
            test::kLargestDeviate * estimate.error + 1e-6 * std::abs(expected));
  EXPECT_LE(estimate.error, LargestError(1e-3) * std::abs(expected));
}

}  // namespace candela::testing_support
