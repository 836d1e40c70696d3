#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "lights/area_light.h"
#include "lights/directional_light.h"
#include "lights/point_light.h"
#include "lights/registry.h"
#include "lights/spot_light.h"
#include "math/elementary.h"
#include "sampling/warp.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// color / (attenuation D^2): 0.9 / (0.025 * 25) = 1.44.
TEST(PointLight, FallsWithTheSquareOfTheDistance) {
  const PointLight light({0, 5, 0}, {0.9f, 1.8f, 0}, 0.025f);
  const LightSample sample = light.SampleIncident({0, 0, 0});
  EXPECT_EQ(sample.direction, (Vec3{0, 1, 0}));
  EXPECT_EQ(sample.distance, 5.0f);
  EXPECT_FLOAT_EQ(sample.radiance[0], 1.44f);
  EXPECT_FLOAT_EQ(sample.radiance[1], 2.88f);
  EXPECT_EQ(sample.radiance[2], 0.0f);
}

TEST(PointLight, GivesNothingToThePointItShinesFrom) {
  const LightSample sample = PointLight({1, 2, 3}, {1, 1, 1}, 1).SampleIncident({1, 2, 3});
  EXPECT_TRUE(sample.radiance.IsBlack());
  EXPECT_EQ(sample.direction, (Vec3{0, 0, 0}));
}

// The course has light that takes away; it must be chosen to do so.
TEST(PointLight, HasAPowerWhateverTheSignsOfItsColour) {
  EXPECT_GT(PointLight({}, {1, -0.5f, -0.5f}, 1).Reach().power, 0);
  EXPECT_GT(PointLight({}, {-1, -1, -1}, 1).Reach().power, 0);
  EXPECT_EQ(PointLight({}, {0, 0, 0}, 1).Reach().power, 0);
}

TEST(PointLight, StandsInTheOriginOfItsNode) {
  const LightContext context{Transform(Mat4::Translate({0, 7, 0}) * Mat4::Scale({2, 2, 2})), false};
  const TypedSpec spec{"point", {}, {{{"attenuation", {}, {{"1", {}}}}}}};
  Diagnostics diagnostics;
  const auto light = CreateLight(spec, context, &diagnostics);
  ASSERT_TRUE(light);
  EXPECT_EQ(light->SampleIncident({0, 5, 0}).distance, 2.0f);
  EXPECT_EQ(light->SampleIncident({0, 5, 0}).radiance.ToRgb(), (Rgb{0.25f, 0.25f, 0.25f}));
}

TEST(DirectionalLight, IsTheSameEverywhereAndInfinitelyFar) {
  const DirectionalLight light({0, -2, 0}, {1, 0.5f, 0});
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1e6f, 5, 5}}) {
    const LightSample sample = light.SampleIncident(p);
    EXPECT_EQ(sample.direction, (Vec3{0, 1, 0}));
    EXPECT_EQ(sample.radiance.ToRgb(), (Rgb{1, 0.5f, 0}));
    EXPECT_EQ(sample.distance, std::numeric_limits<float>::max());
  }
}

TEST(DirectionalLight, TheLengthOfItsDirectionDoesNotMatter) {
  for (const float length : {1e-40f, 1e-25f, 1e25f, 1e38f}) {
    const LightSample sample =
        DirectionalLight({0, 0, -length}, {1, 1, 1}).SampleIncident({0, 0, 0});
    EXPECT_EQ(sample.direction, (Vec3{0, 0, 1})) << length;
  }
}

TEST(DirectionalLight, NodesDoNotTurnIt) {
  const LightContext context{Transform(Mat4::Rotate(0, 90)), false};
  const TypedSpec spec{
      "directional", {}, {{{"direction", {}, {{"0", {}}, {"-1", {}}, {"0", {}}}}}}};
  Diagnostics diagnostics;
  const auto light = CreateLight(spec, context, &diagnostics);
  ASSERT_TRUE(light);
  EXPECT_EQ(light->SampleIncident({0, 0, 0}).direction, (Vec3{0, 1, 0}));
}

TEST(AreaLight, ShinesWithTheSameRadianceInAllDirections) {
  const AreaLight light(Spectrum(Rgb{5, 4, 3}), true);
  EXPECT_TRUE(light.IsSurface());
  EXPECT_EQ(light.Emitted({}, {0, 0, 1}).ToRgb(), (Rgb{5, 4, 3}));
  EXPECT_EQ(light.Emitted({}, {0, 0.6f, -0.8f}).ToRgb(), (Rgb{5, 4, 3}));
}

TEST(AreaLight, OfOneSideIsDarkOnTheOther) {
  const AreaLight light(Spectrum(Rgb{5, 4, 3}), false);
  SurfacePoint point;
  point.n_geometric = {0, 0, 1};
  EXPECT_EQ(light.Emitted(point, {0, 0.6f, 0.8f}).ToRgb(), (Rgb{5, 4, 3}));
  EXPECT_TRUE(light.Emitted(point, {0, 0.6f, -0.8f}).IsBlack());
}

TEST(AreaLight, WithoutASurfaceToDrawFromIsFoundByRaysAlone) {
  const AreaLight light(Spectrum(1), true);
  EXPECT_EQ(light.Reach().power, 0.0f);
  EXPECT_EQ(light.SampleIncident({1, 2, 3}, {0.5f, 0.5f}).pdf, 0.0f);
  EXPECT_EQ(light.PdfIncident({1, 2, 3}, {}, {0, 0, 1}), 0.0f);
}

TEST(AreaLight, NeedsASurfaceToShineFrom) {
  Diagnostics diagnostics;
  CreateLight({"area", {}, {}}, {Transform(), false}, &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), ElementsAre(HasSubstr("needs an object in its node")));
}

// Half a degree, as the sun has it, and a wide one.
class SoftSun : public testing::TestWithParam<float> {
 protected:
  const DirectionalLight sun_{{0, -3, 4}, {2, 1, 0.5f}, GetParam()};
  const Vec3 to_sun_{0, 0.6f, -0.8f};
  test::UniformNumbers random_{1};
};
INSTANTIATE_TEST_SUITE_P(Angles, SoftSun, testing::Values(0.53f, 20.0f, 150.0f));

TEST_P(SoftSun, IsSeenWhereItIsDrawnAndNowhereElse) {
  const double cosine = CosDegrees(double{GetParam()} / 2);
  for (int i = 0; i < 10000; ++i) {
    const LightSample sample = sun_.SampleIncident({1, 2, 3}, random_.NextPair());
    ASSERT_GE(static_cast<double>(Dot(sample.direction, to_sun_)), cosine - 1e-6);
    // At the rim rounding decides.
    if (static_cast<double>(Dot(sample.direction, to_sun_)) < cosine + 1e-6) continue;
    ASSERT_EQ(sun_.Emitted({}, -sample.direction), sample.radiance);
    ASSERT_EQ(sun_.PdfIncident({}, {}, sample.direction), sample.pdf);
  }
  for (int i = 0; i < 10000; ++i) {
    const Vec3 w = SampleUniformSphere(random_.NextPair());
    const bool is_seen = static_cast<double>(Dot(w, to_sun_)) >= cosine;
    if (std::abs(static_cast<double>(Dot(w, to_sun_)) - cosine) < 1e-5) continue;
    ASSERT_EQ(sun_.Emitted({}, -w).IsBlack(), !is_seen);
  }
}

// The integral of radiance times cosine over the disk: color at normal incidence, whatever the
// angle.
TEST_P(SoftSun, GivesTheSameIrradianceAsAParallelOne) {
  double irradiance = 0;
  constexpr int kSide = 200;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec2 u{(static_cast<float>(i % kSide) + 0.5f) / kSide,
                 (static_cast<float>(i / kSide) + 0.5f) / kSide};
    const LightSample sample = sun_.SampleIncident({0, 0, 0}, u);
    irradiance += static_cast<double>(sample.radiance[0]) *
                  static_cast<double>(Dot(sample.direction, to_sun_)) /
                  static_cast<double>(sample.pdf) / (kSide * kSide);
  }
  EXPECT_NEAR(irradiance, 2, 2e-5);
}

TEST_P(SoftSun, StandsForItsMiddleWhereOneDirectionIsAskedFor) {
  const LightSample sample = sun_.SampleIncident({1, 2, 3});
  EXPECT_LT(Length(sample.direction - to_sun_), 1e-6f);
  EXPECT_EQ(sample.radiance.ToRgb(), (Rgb{2, 1, 0.5f}));
  EXPECT_FALSE(sun_.IsSurface());
}

TEST(DirectionalLight, WithoutAnAngleCannotBeMet) {
  const DirectionalLight light({0, 0, -1}, {1, 1, 1});
  EXPECT_EQ(light.Kind(), LightKind::kPoint);
  EXPECT_TRUE(light.Emitted({}, {0, 0, -1}).IsBlack());
}

TEST(DirectionalLight, OfHalfTheSkyOrMoreIsAnError) {
  Diagnostics diagnostics;
  const TypedSpec spec{
      "directional",
      {},
      {{{"direction", {}, {{"0", {}}, {"-1", {}}, {"0", {}}}}, {"angle", {}, {{"180", {}}}}}}};
  CreateLight(spec, {Transform(), false}, &diagnostics);
  EXPECT_THAT(diagnostics.Lines(),
              ElementsAre(HasSubstr("'angle' expects an angle from 0 to below 180 degrees")));
}

/// Down from a height of 1, with a cone of 60 degrees of which the outer half fades.
SpotLight Spot() {
  const float inner = static_cast<float>(CosDegrees(15)),
              outer = static_cast<float>(CosDegrees(30));
  return SpotLight({0, 1, 0}, {{0, -2, 0}, inner, outer}, {8, 8, 8}, 2);
}

float IrradianceBelowSpot(double degrees) {
  const auto x = static_cast<float>(TanDegrees(degrees));
  const LightSample sample = Spot().SampleIncident({x, 0, 0});
  return sample.radiance[0] * (1 + x * x);  // As if at distance 1.
}

TEST(SpotLight, IsAPointLightWithinItsInnerCone) {
  EXPECT_FLOAT_EQ(IrradianceBelowSpot(0), 4);
  EXPECT_FLOAT_EQ(IrradianceBelowSpot(14), 4);
}

TEST(SpotLight, FadesSmoothlyToItsRim) {
  const double middle = (CosDegrees(15) + CosDegrees(30)) / 2;
  EXPECT_NEAR(IrradianceBelowSpot(Acos(middle) * 180 / kPi), 2, 1e-4);
  float last = 4;
  for (int degrees = 15; degrees <= 30; ++degrees) {
    const float value = IrradianceBelowSpot(degrees);
    EXPECT_LE(value, last + 1e-5f);
    EXPECT_LT(last - value, 0.7f) << degrees;
    last = value;
  }
  EXPECT_EQ(IrradianceBelowSpot(30.01), 0.0f);
}

TEST(SpotLight, IsDarkBehind) {
  EXPECT_TRUE(Spot().SampleIncident({0, 3, 0}).radiance.IsBlack());
}

TEST(SpotLight, IsTurnedByItsNode) {
  const LightContext context{Transform(Mat4::Rotate(2, 90)), false};
  const TypedSpec spec{
      "spot",
      {},
      {{{"direction", {}, {{"0", {}}, {"-1", {}}, {"0", {}}}}, {"angle", {}, {{"40", {}}}}}}};
  Diagnostics diagnostics;
  const auto light = CreateLight(spec, context, &diagnostics);
  ASSERT_TRUE(light);
  EXPECT_FALSE(light->SampleIncident({1, 0, 0}).radiance.IsBlack());
  EXPECT_TRUE(light->SampleIncident({0, -1, 0}).radiance.IsBlack());
}

TEST(LightsWithoutExtent, AreNotSeenByRays) {
  EXPECT_TRUE(PointLight({0, 0, 0}, {1, 1, 1}, 1).Emitted({}, {0, 0, 1}).IsBlack());
  EXPECT_TRUE(DirectionalLight({0, 0, 1}, {1, 1, 1}).Emitted({}, {0, 0, 1}).IsBlack());
}

}  // namespace
}  // namespace candela
