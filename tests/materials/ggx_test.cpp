#include "materials/ggx.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

constexpr Ggx kHalf = {0.5f, 0.5f};
constexpr Ggx kBrushed = {0.6f, 0.15f};

Vec3 At(double degrees, double azimuth = 0) {
  return ToFloat({SinDegrees(degrees) * CosDegrees(azimuth),
                  SinDegrees(degrees) * SinDegrees(azimuth), CosDegrees(degrees)});
}

/// The integral of a function over the upper hemisphere, by midpoints in the slopes' polar angle,
/// which is where the normals of smooth surfaces crowd.
template <class Function>
double IntegralOverHemisphere(const Function& function) {
  constexpr int kSteps = 1000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double theta = kPi / 2 * (i + 0.5) / kSteps;
    for (int j = 0; j < kSteps; ++j) {
      const double phi = 2 * kPi * (j + 0.5) / kSteps;
      const Vec3d w{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                    std::cos(theta)};
      sum += std::sin(theta) * static_cast<double>(function(ToFloat(w)));
    }
  }
  return sum * (kPi / 2) * (2 * kPi) / (kSteps * kSteps);
}

// CF32: D(0) = 1 / (pi alpha^2); G1 = 1 / (1 + Lambda).
TEST(Ggx, HasTheValuesOfItsFormulas) {
  EXPECT_NEAR(kHalf.Density({0, 0, 1}), 1.273240, 1e-6);
  EXPECT_NEAR(kHalf.Masking(At(45)), 0.944272, 1e-6);
  EXPECT_EQ(kHalf.Masking({0, 0, 1}), 1);
  EXPECT_EQ(kHalf.Masking({1, 0, 0}), 0);
}

// CF32
TEST(Ggx, ProjectedAreaOfTheFacetsIsThatOfTheSurface) {
  for (const Ggx& surface : {kHalf, kBrushed, Ggx{1, 1}}) {
    const double area = IntegralOverHemisphere([&](Vec3 m) { return surface.Density(m) * m.z; });
    EXPECT_NEAR(area, 1, 1e-4);
  }
}

// P6: seen from any direction, the visible facets cover what the surface covers.
TEST(Ggx, VisibleFacetsCoverTheSurface) {
  for (const Ggx& surface : {kHalf, kBrushed, Ggx{1, 1}}) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
      const Vec3 wo = At(degrees, 30);
      const double area =
          IntegralOverHemisphere([&](Vec3 m) { return surface.VisibleDensity(wo, m); });
      EXPECT_NEAR(area, 1, 1e-3) << degrees;
    }
  }
}

// P6: the weak furnace: without shadowing a mirror of facets loses nothing, above or below the
// horizon. In terms of the facets' normals the integral is that of visible ones, so here it is
// taken over the reflected direction: G1 D / (4 cos).
TEST(Ggx, WeakFurnaceLosesNothing) {
  const Vec3 wo = At(50, 20);
  for (const Ggx& surface : {kHalf, Ggx{0.8f, 0.3f}}) {
    double whole = 0;
    for (const float side : {1.0f, -1.0f}) {
      whole += IntegralOverHemisphere([&](Vec3 w) {
        const Vec3 half = wo + Vec3{w.x, w.y, side * w.z};
        const Vec3 m = Normalize(half);
        if (!(m.z > 0)) return 0.0f;
        return surface.Masking(wo) * surface.Density(m) / (4 * wo.z);
      });
    }
    EXPECT_NEAR(whole, 1, 1e-3);
  }
}

TEST(Ggx, BothDirectionsSeeLessThanOne) {
  const Vec3 wo = At(60), wi = At(40, 120);
  EXPECT_LT(kHalf.MaskingAndShadowing(wo, wi), kHalf.Masking(wo));
  EXPECT_GT(kHalf.MaskingAndShadowing(wo, wi), kHalf.Masking(wo) * kHalf.Masking(wi))
      << "deep places are hidden from both: the two are correlated";
}

}  // namespace
}  // namespace candela
