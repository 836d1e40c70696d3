#pragma once

#include "tests/materials/scatter.h"
#include "tests/support/effort.h"

// Light comes from everywhere alike: what absorbs nothing cannot be seen in it.

namespace candela::test {

inline const Vec3 kNormal = Normalize(Vec3{1, -2, 3});
inline constexpr float kAlphas[] = {0.01f, 0.1f, 0.25f, 0.5f, 1};

/// The surface gives back everything, by `tolerance` beyond the error of the estimate. Above 1 it
/// would make light.
inline void ExpectWhite(const Bsdf& bsdf, double tolerance, double azimuth = 40) {
  UniformNumbers random(7);
  for (const double degrees : kIncidences) {
    const Albedo albedo = AlbedoOf(bsdf, DirectionAt(bsdf.frame, degrees, azimuth), 10000, &random);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(albedo.mean[c], 1, tolerance + kLargestDeviate * albedo.error[c]) << degrees;
      EXPECT_LE(albedo.error[c], testing_support::kIsSanitized ? 0.08 : 0.02)
          << degrees << ": the estimate is too noisy to tell";
    }
  }
}

inline void ExpectWhite(const Material& material, double tolerance, bool is_outside = true) {
  ExpectWhite(BsdfOf(material, kNormal, is_outside), tolerance);
}

}  // namespace candela::test
