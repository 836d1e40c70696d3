// The sky after Preetham, Shirley and Smits 1999, against numbers that were worked out from the
// formulas of the paper apart from this code, and the sun against what is known of it.

#include "textures/daylight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/elementary.h"
#include "textures/cie_colour.h"
#include "textures/daylight_map.h"
#include "textures/sun_spectrum.h"

namespace candela {
namespace {

/// In the plane of the sun: at an angle to the zenith, towards the sun or, if negative, away.
Vec3 DirectionAt(double degrees) {
  return Normalize(ToFloat(Vec3d{0, CosDegrees(degrees), -SinDegrees(degrees)}));
}

Daylight SkyWithSunAt(float turbidity, double degrees_to_zenith) {
  return {turbidity, DirectionAt(degrees_to_zenith)};
}

double Luminance(Rgb rgb) {
  return double{rgb.x} * 0.2126729 + double{rgb.y} * 0.7151522 + double{rgb.z} * 0.0721750;
}

TEST(Sky, HasTheLuminanceOfThePaperAtTheZenith) {
  EXPECT_NEAR(SkyWithSunAt(2, 60).SkyColour({0, 1, 0}).luminance, 3.487327, 1e-5);
  EXPECT_NEAR(SkyWithSunAt(3, 45).SkyColour({0, 1, 0}).luminance, 7.320358, 1e-5);
  EXPECT_NEAR(SkyWithSunAt(6, 20).SkyColour({0, 1, 0}).luminance, 28.919407, 1e-4);
}

TEST(Sky, HasTheRatiosOfThePaper) {
  const Daylight sky = SkyWithSunAt(3, 60);
  const double zenith = sky.SkyColour({0, 1, 0}).luminance;
  const auto ratio = [&](double degrees) {
    return sky.SkyColour(DirectionAt(degrees)).luminance / zenith;
  };
  EXPECT_NEAR(ratio(90), 3.486015, 1e-4) << "the horizon below the sun";
  EXPECT_NEAR(ratio(-90), 1.435685, 1e-4) << "the horizon opposite to it";
  EXPECT_NEAR(ratio(60), 5.986769, 1e-4) << "beside the sun";
  EXPECT_NEAR(ratio(30), 1.940523, 1e-4);
  EXPECT_NEAR(ratio(-60), 1.018346, 1e-4);
}

TEST(Sky, HasTheColoursOfThePaper) {
  const Daylight sky = SkyWithSunAt(3, 60);
  EXPECT_NEAR(sky.SkyColour({0, 1, 0}).x, 0.244929, 1e-5);
  EXPECT_NEAR(sky.SkyColour({0, 1, 0}).y, 0.252573, 1e-5);
  EXPECT_NEAR(sky.SkyColour(DirectionAt(-60)).x, 0.249326, 1e-5);
  EXPECT_NEAR(sky.SkyColour(DirectionAt(-60)).y, 0.264994, 1e-5);
}

// The colour that pictures get has the luminance; the zenith is blue.
TEST(Sky, KeepsItsLuminanceAsAColour) {
  for (const float turbidity : {2.0f, 3.0f, 6.0f}) {
    const Daylight sky = SkyWithSunAt(turbidity, 50);
    for (const double degrees : {-80.0, -40.0, 0.0, 20.0, 50.0, 85.0}) {
      const Vec3 w = DirectionAt(degrees);
      const double luminance = sky.SkyColour(w).luminance;
      EXPECT_NEAR(Luminance(sky.SkyRadiance(w)) / luminance, 1, 1e-3) << degrees;
    }
    const Rgb zenith = sky.SkyRadiance({0, 1, 0});
    EXPECT_GT(zenith.z, 1.3f * zenith.x);
  }
}

// Whatever the sun and the haze, in all directions.
TEST(Sky, IsFiniteAndNotNegative) {
  for (const float turbidity : {2.0f, 4.0f, 10.0f}) {
    for (const double sun : {0.0, 1.0, 45.0, 89.0, 90.0}) {
      const Daylight sky = SkyWithSunAt(turbidity, sun);
      for (int i = -120; i <= 120; ++i) {
        const Rgb radiance = sky.SkyRadiance(DirectionAt(i));
        ASSERT_TRUE(IsFinite(radiance));
        ASSERT_GE(std::min({radiance.x, radiance.y, radiance.z}), 0);
        ASSERT_GT(radiance.x + radiance.y + radiance.z, 0);
      }
      ASSERT_TRUE(IsFinite(sky.SunIrradiance()));
      // Thick air leaves nothing of the sun on the horizon.
      ASSERT_GE(sky.SunIrradiance().x, sun < 89 ? 1e-3f : 0.0f);
    }
  }
}

// Measured values of the illuminance by the sun outside of the air go from 127 to 134 klx.
TEST(Sun, HasItsKnownIlluminance) {
  EXPECT_NEAR(Luminance(SunIrradianceInSpace(0.533)), 130.5, 3.5);
}

// The disk of twice the radius has four times the area.
TEST(Sun, GivesLightByItsSolidAngle) {
  EXPECT_NEAR(SunIrradianceInSpace(1).y / SunIrradianceInSpace(0.5).y, 4, 1e-3);
}

// Through dry clean air about a fifth is lost at the zenith; through more of it, more, and more of
// the blue.
TEST(Sun, FadesAndReddensTowardsTheHorizon) {
  const double outside = Luminance(SunIrradianceInSpace(0.533));
  const double high = Luminance(SkyWithSunAt(2, 0).SunIrradiance());
  EXPECT_GT(high / outside, 0.7);
  EXPECT_LT(high / outside, 0.9);
  for (const float turbidity : {2.0f, 5.0f}) {
    Rgb last = SkyWithSunAt(turbidity, 0).SunIrradiance();
    for (const double degrees : {30.0, 60.0, 75.0, 85.0, 88.0}) {
      const Rgb sun = SkyWithSunAt(turbidity, degrees).SunIrradiance();
      EXPECT_LT(sun.x, last.x);
      EXPECT_LT(sun.z / sun.x, last.z / last.x) << degrees;
      last = sun;
    }
  }
}

// The equal-energy spectrum has the same X, Y and Z, and Y integrates to 106.857 nm.
TEST(ColourMatching, IsThatOfTheStandardObserver) {
  Vec3d sum;
  for (int nanometres = 360; nanometres <= 830; ++nanometres) {
    sum = sum + ColourMatching(nanometres);
  }
  EXPECT_NEAR(sum.x, 106.87, 1);
  EXPECT_NEAR(sum.y, 106.86, 1);
  EXPECT_NEAR(sum.z, 106.89, 1);
  EXPECT_NEAR(ColourMatching(555).y, 1, 0.01);
}

TEST(RgbOfXyz, TakesTheWhiteOfD65ToWhite) {
  const Vec3 white = RgbOfXyz({0.95047, 1, 1.08883});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-4);
}

/// The irradiance that directions above the horizon give to level ground.
template <class Radiance>
Vec3d IrradianceFromAbove(const Radiance& radiance) {
  constexpr int kRings = 400, kSectors = 800;
  Vec3d sum;
  for (int i = 0; i < kRings; ++i) {
    const double cosine = std::sqrt((i + 0.5) / kRings);  // Rings of equal irradiance.
    const double sine = std::sqrt(1 - cosine * cosine);
    for (int k = 0; k < kSectors; ++k) {
      const double turn = 360 * (k + 0.5) / kSectors;
      const Vec3d w{SinDegrees(turn) * sine, cosine, -CosDegrees(turn) * sine};
      sum = sum + ToDouble(radiance(Normalize(ToFloat(w)))) * (kPi / (kRings * kSectors));
    }
  }
  return sum;
}

// The picture that rays see holds as much light as the model.
TEST(DaylightMap, HoldsTheLightOfTheSky) {
  for (const double degrees : {10.0, 60.0, 85.0}) {
    const Vec3 to_sun = DirectionAt(degrees);
    const Daylight sky(2.5f, to_sun);
    const EnvironmentMap map = MakeDaylightMap(sky, to_sun, sky.SunIrradiance(), {}, 0.5f);
    const Vec3d of_map = IrradianceFromAbove([&](Vec3 w) { return map.Lookup(w); });
    const Vec3d of_sky = IrradianceFromAbove([&](Vec3 w) { return sky.SkyRadiance(w); });
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(of_map[c] / (0.5 * of_sky[c]), 1, 5e-4) << degrees;
    // Around the sun it is pointed, and the zenith has the colour of the ring around it.
    for (const double place : {-80.0, -20.0, 0.0, 30.0, 60.0, 80.0}) {
      const Vec3 w = DirectionAt(place);
      const bool is_blurred = place == 0 || place == degrees;
      EXPECT_NEAR(map.Lookup(w).y / (0.5f * sky.SkyRadiance(w).y), 1, is_blurred ? 2e-2 : 1e-3)
          << place;
    }
  }
}

// Ground throws back albedo / pi of what sky and sun give it.
TEST(DaylightMap, HasGroundLitByTheSkyAndTheSun) {
  const Vec3 to_sun = DirectionAt(60);
  const Daylight sky(3, to_sun);
  const EnvironmentMap map =
      MakeDaylightMap(sky, to_sun, sky.SunIrradiance(), {0.1f, 0.2f, 0.4f}, 1);
  const Vec3d of_sky = IrradianceFromAbove([&](Vec3 w) { return sky.SkyRadiance(w); });
  const Vec3d irradiance = of_sky + ToDouble(sky.SunIrradiance()) * 0.5;
  const double albedo[] = {0.1, 0.2, 0.4};
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(map.Lookup({0, -1, 0})[c], albedo[c] * irradiance[c] / kPi, 1e-3 * irradiance[c]);
    EXPECT_EQ(map.Lookup({0, -1, 0})[c], map.Lookup({0.6f, -0.8f, 0})[c]);
  }
  const EnvironmentMap without = MakeDaylightMap(sky, to_sun, Rgb(), {0.1f, 0.2f, 0.4f}, 1);
  EXPECT_NEAR(without.Lookup({0, -1, 0}).z, 0.4 * of_sky.z / kPi, 1e-3 * of_sky.z);
}

}  // namespace
}  // namespace candela
