// Refractive indices that depend on the wavelength.
#include "materials/dispersion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "materials/dielectric.h"
#include "math/elementary.h"
#include "math/wavelength.h"
#include "tests/materials/scatter.h"

namespace candela {
namespace {

// The lines C, d and F.
constexpr float kRed = 656.2725f, kYellow = Dispersion::kYellow, kBlue = 486.1327f;

/// Crown glass BK7, by the numbers of its maker.
Dispersion Crown() {
  return Dispersion::Sellmeier({1.03961212f, 0.231792344f, 1.01046945f},
                               {0.00600069867f, 0.0200179144f, 103.560653f});
}

TEST(Dispersion, OfCrownGlassBySellmeiersEquation) {
  EXPECT_NEAR(Crown().At(kRed), 1.51432f, 1e-5f);
  EXPECT_NEAR(Crown().At(kYellow), 1.51680f, 1e-5f);
  EXPECT_NEAR(Crown().At(kBlue), 1.52238f, 1e-5f);
}

TEST(Dispersion, ByCauchysEquation) {
  const Dispersion water = Dispersion::Cauchy({1.3199f, 6.878e-3f, -3.0e-4f});
  EXPECT_NEAR(water.At(500), 1.3199f + 6.878e-3f / 0.25f - 3.0e-4f / 0.0625f, 1e-6f);
}

TEST(Dispersion, HasItsAbbeNumber) {
  for (const float abbe : {20.0f, 64.17f, 200.0f}) {
    const Dispersion glass = Dispersion::OfAbbeNumber(1.6f, abbe);
    EXPECT_NEAR(glass.At(kYellow), 1.6f, 1e-6f);
    EXPECT_NEAR(0.6f / (glass.At(kBlue) - glass.At(kRed)), abbe, 2e-3f * abbe);
  }
}

/// The way on of light that comes along `direction` to a surface with the outward normal `n`:
/// through it, or reflected.
Vec3 Onwards(const DielectricMaterial& glass, float wavelength, Vec3 n, Vec3 direction,
             bool through) {
  SurfacePoint point;
  point.n_geometric = point.n_shading = n;
  Bsdf bsdf;
  bsdf.frame = Frame::FromNormal(Dot(n, direction) < 0 ? n : -n);
  bsdf.wavelength = wavelength;
  glass.Evaluate(point, &bsdf);
  EXPECT_TRUE(bsdf.is_dispersive);
  const BsdfSample sample = Sample(bsdf, -direction, {through ? 0.9999f : 0, 0.5f});
  EXPECT_EQ(sample.is_transmission, through);
  return sample.wi;
}

double DegreesBetween(Vec3 a, Vec3 b) {
  const auto sine = static_cast<double>(Length(Cross(a, b)));
  return Atan2(static_cast<float>(sine), Dot(a, b)) / static_cast<float>(kPi) * 180;
}

/// Glass of one index, as light of any colour sees it, and a little different for others.
DielectricMaterial GlassOf(float index) {
  const Dispersion dispersion = Dispersion::Cauchy({index - 1e-6f, 1e-7f, 0});
  return {Medium{index, {}, dispersion}, Roughness()};
}

/// By how much a prism of 60 degrees turns light that comes in at `incidence` degrees.
double Deviation(const DielectricMaterial& glass, float wavelength, double incidence) {
  const auto along = [](double degrees) {
    return ToFloat({CosDegrees(degrees), SinDegrees(degrees), 0});
  };
  // The faces look to the left and to the right, and 30 degrees up.
  const Vec3 left = along(150), right = along(30);
  const Vec3 direction = along(150 + incidence - 180);
  const Vec3 inside = Onwards(glass, wavelength, left, direction, true);
  return DegreesBetween(direction, Onwards(glass, wavelength, right, inside, true));
}

// CF21
TEST(Prism, TurnsLightByTheClosedForm) {
  const DielectricMaterial glass = GlassOf(1.5f);
  EXPECT_NEAR(Deviation(glass, kYellow, 40), 38.465561, 5e-4);
  EXPECT_NEAR(Deviation(glass, kYellow, 45), 37.381307, 5e-4);
  EXPECT_NEAR(Deviation(glass, kYellow, 60), 38.876770, 5e-4);
  double least = 180;
  for (int i = 0; i <= 200; ++i) {
    least = std::min(least, Deviation(glass, kYellow, 45 + 0.05 * i));
  }
  EXPECT_NEAR(least, 37.180756, 5e-4);
}

// CF21: at the least deviation, where the angle of incidence is half of it and of the prism's.
TEST(Prism, SplitsLightIntoItsColours) {
  const DielectricMaterial glass({Crown().At(kYellow), {}, Crown()}, Roughness());
  const struct {
    float wavelength;
    double deviation;
  } colours[] = {{kRed, 38.428931}, {kYellow, 38.646695}, {kBlue, 39.138437}};
  for (const auto& [wavelength, deviation] : colours) {
    EXPECT_NEAR(Deviation(glass, wavelength, (deviation + 60) / 2), deviation, 1e-3) << wavelength;
  }
}

/// The angle between where the sun is seen and where light goes that a drop has reflected so often
/// inside, at the place where it is brightest: where it turns back.
double Bow(float index, int reflections) {
  const DielectricMaterial water = GlassOf(index);
  double extreme = reflections == 1 ? 0 : 180;
  for (int i = 1; i < 2000; ++i) {
    const double height = i / 2000.0;
    Vec3 direction{1, 0, 0}, n = ToFloat({-std::sqrt(1 - height * height), height, 0});
    direction = Onwards(water, kYellow, n, direction, true);
    for (int k = 0; k <= reflections; ++k) {
      n = Normalize(n - direction * (2 * Dot(n, direction)));  // The far end of the way through.
      direction = Onwards(water, kYellow, n, direction, k == reflections);
    }
    const double angle = DegreesBetween(direction, {-1, 0, 0});
    extreme = reflections == 1 ? std::max(extreme, angle) : std::min(extreme, angle);
  }
  return extreme;
}

// CF22
TEST(Rainbow, StandsWhereTheClosedFormSays) {
  const struct {
    float index;
    double first, second;
  } colours[] = {{1.331f, 42.370, 50.365}, {1.333f, 42.078, 50.891}, {1.343f, 40.646, 53.478}};
  for (const auto& [index, first, second] : colours) {
    EXPECT_NEAR(Bow(index, 1), first, 0.01) << index;
    EXPECT_NEAR(Bow(index, 2), second, 0.01) << index;
  }
}

TEST(Dispersion, OfLightOfAllColoursIsNone) {
  const Medium medium{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 10)};
  EXPECT_EQ(medium.IndexAt(0), 1.5f);
  const DielectricMaterial glass(medium, Roughness());
  EXPECT_FALSE(test::BsdfOf(glass, {0, 0, 1}).is_dispersive);
}

}  // namespace
}  // namespace candela
