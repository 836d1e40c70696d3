#include "scene/fog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

Fog Make(FogSpec::Profile profile, float density, float base = 0, float height = 1) {
  FogSpec spec;
  spec.profile = profile;
  spec.density = density;
  spec.base = base;
  spec.height = height;
  return Fog(spec);
}

Fog Ramp(float density, float base, float height) {
  return Make(FogSpec::Profile::kLinear, density, base, height);
}

Fog Exponential(float density, float base, float height) {
  return Make(FogSpec::Profile::kExponential, density, base, height);
}

// CF28: e to the power of minus the density times the length.
TEST(HomogeneousFog, LeavesThePartOfBeersLaw) {
  const Fog fog = Make(FogSpec::Profile::kHomogeneous, 0.7f);
  EXPECT_NEAR(fog.Transmittance({1, 2, 3}, {0, 0, 1}, 2), 0.246597, 1e-6);
  EXPECT_EQ(fog.Transmittance({1, 2, 3}, {0, 0, 1}, 0), 1);
  EXPECT_EQ(fog.Transmittance({1, 2, 3}, {0, 0, 1}, kEndless), 0);
}

TEST(HomogeneousFog, OfNoDensityIsNotThereEvenWithoutEnd) {
  EXPECT_EQ(Make(FogSpec::Profile::kHomogeneous, 0).Transmittance({}, {0, 0, 1}, kEndless), 1);
}

// CF28: from the top of a ramp down, where the density is a times the depth, the optical depth is
// a D^2 / 2: here a = 0.5, D = 2.
TEST(LinearFog, LeavesThePartOfTheSquareOfTheDepth) {
  EXPECT_NEAR(Ramp(1, 1, 2).Transmittance({0, 3, 0}, {0, -1, 0}, 2), 0.367879, 1e-6);
  // And the same way upwards, the air above it included.
  EXPECT_NEAR(Ramp(1, 1, 2).Transmittance({0, 1, 0}, {0, 1, 0}, 20), 0.367879, 1e-6);
  EXPECT_NEAR(Ramp(1, 1, 2).Transmittance({0, 1, 0}, {0, 1, 0}, kEndless), 0.367879, 1e-6);
}

TEST(LinearFog, IsEvenBelowItsRampAndNothingAbove) {
  const Fog fog = Ramp(0.7f, 1, 2);
  EXPECT_NEAR(fog.Transmittance({0, 0, 0}, {0, -1, 0}, 2), 0.246597, 1e-6);
  EXPECT_NEAR(fog.Transmittance({0, 0, 0}, {1, 0, 0}, 2), 0.246597, 1e-6);
  EXPECT_EQ(fog.Transmittance({0, 3, 0}, {1, 0, 0}, kEndless), 1);
  EXPECT_EQ(fog.Transmittance({0, 3, 0}, {0, 1, 0}, kEndless), 1);
  EXPECT_EQ(fog.Transmittance({0, 2.9f, 0}, {1, 0, 0}, kEndless), 0);
  EXPECT_EQ(fog.Transmittance({0, 9, 0}, {0, -1, 0}, kEndless), 0);
}

// Straight up from the base it is density times height in all.
TEST(ExponentialFog, HasAColumnOfDensityTimesHeight) {
  const Fog fog = Exponential(0.7f, 5, 2);
  EXPECT_NEAR(fog.OpticalDepth({0, 5, 0}, {0, 1, 0}, kEndless), 1.4, 1e-6);
  EXPECT_NEAR(fog.OpticalDepth({0, 7, 0}, {0, 1, 0}, kEndless), 1.4 / std::exp(1.0), 1e-6);
  EXPECT_NEAR(fog.OpticalDepth({0, 5, 0}, {0, 0.6f, 0.8f}, kEndless), 1.4 / 0.6, 1e-6);
  EXPECT_NEAR(fog.OpticalDepth({0, 7, 0}, {0, -1, 0}, 2), 1.4 * (1 - std::exp(-1.0)), 1e-6);
  EXPECT_EQ(fog.Transmittance({0, 5, 0}, {0, -1, 0}, kEndless), 0);
  EXPECT_EQ(fog.Transmittance({0, 5, 0}, {1, 0, 0}, kEndless), 0);
}

TEST(ExponentialFog, AlongLevelRaysIsEven) {
  const Fog fog = Exponential(0.7f, 5, 2);
  EXPECT_NEAR(fog.OpticalDepth({0, 5, 0}, {1, 0, 0}, 3), 2.1, 1e-6);
  EXPECT_NEAR(fog.OpticalDepth({0, 7, 0}, {1, 0, 0}, 3), 2.1 / std::exp(1.0), 1e-6);
}

// Far above there is none left, far below there is nothing else; neither is 0 times infinity.
TEST(ExponentialFog, FarAwayIsNothingOrAll) {
  const Fog fog = Exponential(1, 0, 1e-3f);
  for (const Vec3 w : {Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    EXPECT_EQ(fog.Transmittance({0, 1e30f, 0}, w, kEndless), 1);
  }
  for (const Vec3 w : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    EXPECT_EQ(fog.Transmittance({0, -1e30f, 0}, w, 1), 0);
  }
  EXPECT_EQ(fog.Transmittance({0, 1e30f, 0}, {0, -1, 0}, kEndless), 0);
}

/// The integral of the density in so many steps.
double Marched(FogSpec::Profile profile, double y, double slope, double distance) {
  constexpr int kSteps = 200000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double above = (y + slope * distance * (i + 0.5) / kSteps - 0.5) / 1.5;
    sum += profile == FogSpec::Profile::kExponential ? std::exp(-above)
                                                     : std::min(1.0, std::max(0.0, 1 - above));
  }
  return 0.75 * sum * distance / kSteps;
}

// The formulas change places near level rays; both are the integral on either side of that.
TEST(Fog, IsTheIntegralOfItsDensityHoweverFlatTheRay) {
  for (const auto profile : {FogSpec::Profile::kExponential, FogSpec::Profile::kLinear}) {
    const Fog fog = Make(profile, 0.75f, 0.5f, 1.5f);
    for (const float slope : {0.0f, 1e-9f, -1e-7f, 4e-7f, 6e-7f, 1e-5f, 0.01f, -0.3f, 0.8f}) {
      for (const float y : {-1.0f, 0.6f, 1.25f}) {
        const Vec3 w{std::sqrt(1 - slope * slope), slope, 0};
        const double expected = Marched(profile, y, slope, 3);
        EXPECT_NEAR(fog.OpticalDepth({0, y, 0}, w, 3), expected, 1e-8 * (1 + expected))
            << slope << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace candela
