#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "materials/bsdf.h"
#include "materials/material.h"
#include "math/elementary.h"
#include "tests/sampling/chi_square.h"

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
inline Albedo AlbedoOf(const Bsdf& bsdf, Vec3 wo, int samples, UniformNumbers* random) {
  double sum[3] = {}, squares[3] = {};
  for (int i = 0; i < samples; ++i) {
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

/// The integral of the density over a cell: by midpoints, and where they say something else than
/// those of its quarters, by its quarters. Peaks may be narrow, above all at flat angles.
inline double IntegralOfPdf(const Bsdf& bsdf, Vec3 wo, const SphereCell& cell, int depth) {
  const auto midpoints = [&](const SphereCell& part) {
    constexpr int kSteps = 4;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double theta = part.theta + part.theta_size * (i + 0.5) / kSteps;
      for (int j = 0; j < kSteps; ++j) {
        const double phi = part.phi + part.phi_size * (j + 0.5) / kSteps;
        const Vec3d wi{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                       std::cos(theta)};
        sum +=
            std::sin(theta) * static_cast<double>(Pdf(bsdf, wo, bsdf.frame.ToWorld(ToFloat(wi))));
      }
    }
    return sum * part.theta_size * part.phi_size / (kSteps * kSteps);
  };
  constexpr int kLeastDepth = 1, kMostDepth = 7;
  const double t = cell.theta_size / 2, p = cell.phi_size / 2;
  const SphereCell quarters[] = {{cell.theta, cell.phi, t, p},
                                 {cell.theta, cell.phi + p, t, p},
                                 {cell.theta + t, cell.phi, t, p},
                                 {cell.theta + t, cell.phi + p, t, p}};
  double sum = 0;
  for (const SphereCell& quarter : quarters) sum += midpoints(quarter);
  const bool is_done = depth >= kLeastDepth && std::abs(sum - midpoints(cell)) < 1e-6;
  if (is_done || depth == kMostDepth) return sum;
  sum = 0;
  for (const SphereCell& quarter : quarters) sum += IntegralOfPdf(bsdf, wo, quarter, depth + 1);
  return sum;
}

/// P1: samples follow the density, in 16 x 32 cells of equal solid angle of the whole sphere. Those
/// of single directions, and draws that found none, are what the density leaves to 1. Strength: see
/// chi_square.h.
inline void ExpectSamplesToFollowTheDensity(const Bsdf& bsdf, Vec3 wo, int samples,
                                            UniformNumbers* random) {
  constexpr size_t kHeights = 16, kSectors = 32;
  std::vector<double> shares;
  double sum = 0;
  for (size_t i = 0; i < kHeights; ++i) {
    const double top = std::acos(1 - 2 * static_cast<double>(i) / kHeights);
    const double size = std::acos(1 - 2 * static_cast<double>(i + 1) / kHeights) - top;
    for (size_t j = 0; j < kSectors; ++j) {
      const double turn = 2 * kPi / kSectors;
      shares.push_back(
          IntegralOfPdf(bsdf, wo, {top, turn * static_cast<double>(j), size, turn}, 0));
      sum += shares.back();
    }
  }

  std::vector<uint64_t> counts(shares.size());
  uint64_t others = 0;
  for (int i = 0; i < samples; ++i) {
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
  if (others == static_cast<uint64_t>(samples)) return;
  for (double& share : shares) share /= sum;
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
}

}  // namespace candela::test
