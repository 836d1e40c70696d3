#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "materials/bsdf.h"
#include "materials/material.h"
#include "math/elementary.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/effort.h"

// What tests ask of everything that scatters light.

namespace candela::test {

/// Angles of incidence from head-on to nearly flat, in degrees.
inline constexpr double kIncidences[] = {0, 15, 30, 45, 60, 75, 85, 89};

/// A direction at `degrees` from the frame's z axis.
inline Vec3 DirectionAt(const Frame& frame, double degrees, double azimuth = 40) {
  return frame.ToWorld(ToFloat({SinDegrees(degrees) * CosDegrees(azimuth),
                                SinDegrees(degrees) * SinDegrees(azimuth), CosDegrees(degrees)}));
}

/// What the material does around `n`, seen from its outside or from its inside.
inline Bsdf BsdfOf(const Material& material, Vec3 n, bool is_outside = true) {
  SurfacePoint point;
  point.n_geometric = point.n_shading = n;
  Bsdf bsdf;
  bsdf.frame = Frame::FromNormal(is_outside ? n : -n);
  material.Evaluate(point, &bsdf);
  return bsdf;
}

/// The mean weight of samples, as a share of the power, with its standard error.
struct Albedo {
  double mean[3] = {}, error[3] = {};
};
inline Albedo AlbedoOf(const Bsdf& bsdf, Vec3 wo, uint32_t usual_samples, UniformNumbers* random) {
  const uint32_t samples = testing_support::Samples(usual_samples);
  double sum[3] = {}, squares[3] = {};
  for (uint32_t i = 0; i < samples; ++i) {
    const BsdfSample sample = Sample(bsdf, wo, random->NextPair());
    for (int c = 0; c < 3; ++c) {
      const double share = static_cast<double>(sample.weight[c] * sample.eta * sample.eta);
      sum[c] += share;
      squares[c] += share * share;
    }
  }
  Albedo albedo;
  for (int c = 0; c < 3; ++c) {
    albedo.mean[c] = sum[c] / samples;
    const double variance = squares[c] / samples - albedo.mean[c] * albedo.mean[c];
    albedo.error[c] = std::sqrt(std::max(0.0, variance) / samples);
  }
  return albedo;
}

/// P2: the weight of a sample is the value times the cosine over the density, which both can be
/// asked for as well.
inline void ExpectWeightsToAgree(const Bsdf& bsdf, Vec3 wo, int samples, UniformNumbers* random) {
  for (int i = 0; i < samples; ++i) {
    const BsdfSample sample = Sample(bsdf, wo, random->NextPair());
    // So near the horizon the cosine has few digits.
    const float cosine = std::abs(Dot(bsdf.frame.z, sample.wi));
    if (sample.pdf < 1e-3f || sample.is_delta || cosine < 1e-3f) continue;
    ASSERT_NEAR(Length(sample.wi), 1, 1e-5);
    ASSERT_NEAR(Pdf(bsdf, wo, sample.wi), sample.pdf, 2e-3f * sample.pdf);
    const Spectrum expected = Eval(bsdf, wo, sample.wi) * (cosine / sample.pdf);
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(sample.weight[c], expected[c], 2e-3f * std::max(1.0f, expected[c]));
    }
  }
}

/// A part of the sphere in the angle from the frame's z axis and the one around it.
struct SphereCell {
  double theta, phi, theta_size, phi_size;
};

/// The integral of the density over a cell by Gauss's rule of three points each way, which is exact
/// for polynomials of degree 5.
inline double GaussOfPdf(const Bsdf& bsdf, Vec3 wo, const SphereCell& cell) {
  constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
  constexpr double kNodes[] = {-kNode, 0, kNode}, kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double theta = cell.theta + cell.theta_size * (1 + kNodes[i]) / 2;
    const double sin_theta = std::sin(theta), cos_theta = std::cos(theta);
    for (int j = 0; j < 3; ++j) {
      const double phi = cell.phi + cell.phi_size * (1 + kNodes[j]) / 2;
      const Vec3d wi{sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
      sum += kWeights[i] * kWeights[j] * sin_theta *
             static_cast<double>(Pdf(bsdf, wo, bsdf.frame.ToWorld(ToFloat(wi))));
    }
  }
  return sum * cell.theta_size * cell.phi_size;
}

/// The same by its quarters, and where they say something else than `whole`, which is that of the
/// cell, by theirs. Peaks may be narrow, above all at flat angles.
inline double IntegralOfPdf(const Bsdf& bsdf, Vec3 wo, const SphereCell& cell, double whole,
                            int depth) {
  constexpr int kLeastDepth = 1, kMostDepth = 7;
  const double t = cell.theta_size / 2, p = cell.phi_size / 2;
  const SphereCell quarters[] = {{cell.theta, cell.phi, t, p},
                                 {cell.theta, cell.phi + p, t, p},
                                 {cell.theta + t, cell.phi, t, p},
                                 {cell.theta + t, cell.phi + p, t, p}};
  double parts[4], sum = 0;
  for (int i = 0; i < 4; ++i) sum += parts[i] = GaussOfPdf(bsdf, wo, quarters[i]);
  const bool is_done = depth >= kLeastDepth && std::abs(sum - whole) < 1e-6;
  if (is_done || depth == kMostDepth) return sum;
  sum = 0;
  for (int i = 0; i < 4; ++i) sum += IntegralOfPdf(bsdf, wo, quarters[i], parts[i], depth + 1);
  return sum;
}

/// P1: samples follow the density, in 16 x 32 cells of equal solid angle of the whole sphere. Those
/// of single directions, and draws that found none, are what the density leaves to 1. Strength: see
/// chi_square.h.
inline void ExpectSamplesToFollowTheDensity(const Bsdf& bsdf, Vec3 wo, uint32_t usual_samples,
                                            UniformNumbers* random) {
  const uint32_t samples = testing_support::Samples(usual_samples);
  constexpr size_t kHeights = 16, kSectors = 32;
  std::vector<double> shares;
  double sum = 0;
  for (size_t i = 0; i < kHeights; ++i) {
    const double top = std::acos(1 - 2 * static_cast<double>(i) / kHeights);
    const double size = std::acos(1 - 2 * static_cast<double>(i + 1) / kHeights) - top;
    for (size_t j = 0; j < kSectors; ++j) {
      const double turn = 2 * kPi / kSectors;
      const SphereCell cell{top, turn * static_cast<double>(j), size, turn};
      shares.push_back(IntegralOfPdf(bsdf, wo, cell, GaussOfPdf(bsdf, wo, cell), 0));
      sum += shares.back();
    }
  }

  std::vector<uint64_t> counts(shares.size());
  uint64_t others = 0;
  for (uint32_t i = 0; i < samples; ++i) {
    const BsdfSample sample = Sample(bsdf, wo, random->NextPair());
    if (sample.pdf == 0 || sample.is_delta) {
      ++others;
      continue;
    }
    const Vec3 local = bsdf.frame.ToLocal(sample.wi);
    double turn = std::atan2(static_cast<double>(local.y), static_cast<double>(local.x));
    if (turn < 0) turn += 2 * kPi;
    const auto index = [](double position, size_t size) {
      const double at = position * static_cast<double>(size);
      return std::min(static_cast<size_t>(std::max(at, 0.0)), size - 1);
    };
    const size_t height = index((1 - static_cast<double>(local.z)) / 2, kHeights);
    ++counts[height * kSectors + index(turn / (2 * kPi), kSectors)];
  }
  const double rest = static_cast<double>(others) / samples;
  const double error = std::sqrt(rest * (1 - rest) / samples);
  EXPECT_NEAR(sum, 1 - rest, 1e-3 + kLargestDeviate * error) << "the integral of the density";
  // Chi-square needs some in each cell: of the few under sanitizers there may not be enough.
  constexpr uint64_t kFewest = testing_support::kIsSanitized ? 1000 : 1;
  if (samples - others < kFewest) return;
  for (double& share : shares) share /= sum;
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
}

}  // namespace candela::test
