#include "materials/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/dielectric_lobe.h"
#include "math/elementary.h"

namespace candela {
namespace {

float Reflectance(double degrees, double eta) {
  float beyond;
  return DielectricReflectance(static_cast<float>(CosDegrees(degrees)), static_cast<float>(eta),
                               &beyond);
}

// CF16
TEST(Fresnel, GlassReflectsFourPercentHeadOnAndMoreTheFlatterTheLight) {
  EXPECT_NEAR(Reflectance(0, 1.5), 0.04, 1e-6);
  EXPECT_NEAR(Reflectance(30, 1.5), 0.0415226, 1e-6);
  EXPECT_NEAR(Reflectance(45, 1.5), 0.0502399, 1e-6);
  EXPECT_NEAR(Reflectance(75, 1.5), 0.2530606, 2e-6);
  EXPECT_NEAR(Reflectance(85, 1.5), 0.6127996, 5e-6);
  EXPECT_EQ(Reflectance(90, 1.5), 1);
}

// CF16
TEST(Fresnel, HeadOnTheIndexAloneCounts) {
  EXPECT_NEAR(Reflectance(0, 1.33), 0.0200593, 1e-7);
  EXPECT_NEAR(Reflectance(0, 2.42), 0.1723949, 1e-6);
  EXPECT_EQ(Reflectance(0, 1), 0);
}

// CF17: at atan n the light in the plane of incidence is not reflected: half of the rest is the
// mean.
TEST(Fresnel, AtBrewstersAngleOnePolarisationIsLeft) {
  EXPECT_NEAR(Reflectance(56.309932, 1.5), 0.147929 / 2, 1e-6);
}

// CF17: beyond asin(1 / n) everything stays inside.
TEST(Fresnel, ReflectsAllBeyondTheCriticalAngle) {
  for (const auto& [eta, critical] : {std::pair{1.5, 41.810315}, std::pair{1.33, 48.753467}}) {
    EXPECT_LT(Reflectance(critical - 0.01, 1 / eta), 0.95);
    EXPECT_EQ(Reflectance(critical + 0.01, 1 / eta), 1);
  }
}

TEST(Fresnel, IsTheSameFromBothSidesOfARefractedRay) {
  for (double degrees = 0; degrees < 90; degrees += 7.5) {
    float beyond;
    const auto cosine = static_cast<float>(CosDegrees(degrees));
    const float there = DielectricReflectance(cosine, 1.5f, &beyond);
    float back_beyond;
    EXPECT_NEAR(DielectricReflectance(beyond, 1 / 1.5f, &back_beyond), there, 2e-6) << degrees;
    EXPECT_NEAR(back_beyond, cosine, 1e-6) << degrees;
  }
}

// CF18: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
TEST(Fresnel, MetalHeadOn) {
  const Rgb r = ConductorReflectance(1, {0.2f, 0.2f, 1.5f}, {3.3f, 3.3f, 0});
  EXPECT_NEAR(r.x, 0.935118, 1e-6);
  EXPECT_EQ(r.y, r.x);
  EXPECT_NEAR(r.z, 0.04, 1e-6) << "without absorption it is a dielectric";
}

TEST(Fresnel, AMetalWithoutAbsorptionIsADielectricAtAllAngles) {
  for (double degrees = 0; degrees < 90; degrees += 7.5) {
    const auto cosine = static_cast<float>(CosDegrees(degrees));
    EXPECT_NEAR(ConductorReflectance(cosine, {1.5f, 1.5f, 1.5f}, {}).y, Reflectance(degrees, 1.5),
                2e-6);
  }
}

// Twice the integral of F times the cosine; for n = 1.5 it is known in closed form: Walsh, "The
// reflection factor of a polished glass surface for diffused light", 1926.
TEST(Fresnel, DiffuseLightIsReflectedByNinePercent) {
  EXPECT_NEAR(MeanDielectricReflectance(1.5f), 0.0917788, 2e-5);
  EXPECT_NEAR(MeanConductorReflectance({1.5f, 1.5f, 1.5f}, {}).x, 0.0917788, 2e-5);
}

// CF19: (1 - R)^2 a / (1 - R^2 a^2) and R + R (1 - R)^2 a^2 / (1 - R^2 a^2) with R = 0.04.
TEST(Pane, CountsAllReflectionsBetweenItsFaces) {
  const PaneShares clear = SharesOfPane({1.5f, {0, 0, 0}}, 1);
  EXPECT_NEAR(clear.through.x, 0.923077, 1e-6);
  EXPECT_NEAR(clear.reflected.x, 0.076923, 1e-6);
  const PaneShares tinted = SharesOfPane({1.5f, {0, 0.5f, 0}}, 1);
  EXPECT_NEAR(tinted.through.y, 0.559308, 1e-6);
  EXPECT_NEAR(tinted.reflected.y, 0.053569, 1e-6);
  EXPECT_EQ(tinted.through.x, clear.through.x);
}

TEST(Pane, WithoutAbsorptionLosesNothing) {
  for (double degrees = 0; degrees <= 90; degrees += 7.5) {
    const PaneShares shares = SharesOfPane({1.5f, {}}, static_cast<float>(CosDegrees(degrees)));
    EXPECT_NEAR(shares.through.x + shares.reflected.x, 1, 1e-6) << degrees;
  }
}

// A complex index of 0 lets nothing in: all is reflected, head-on too.
TEST(ConductorReflectance, OfAnIndexOfZeroIsWhole) {
  for (const float cosine : {0.0f, 0.3f, 0.9999f, 1.0f}) {
    EXPECT_EQ(ConductorReflectance(cosine, {0, 0, 0}, {0, 0, 0}), (Rgb{1, 1, 1})) << cosine;
    const Rgb one = ConductorReflectance(cosine, {0, 1.5f, 0.2f}, {0, 2, 3});
    EXPECT_EQ(one.x, 1);
    EXPECT_TRUE(IsFinite(one)) << cosine;
  }
}

}  // namespace
}  // namespace candela
