#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "lights/area_light.h"
#include "lights/directional_light.h"
#include "lights/point_light.h"
#include "lights/registry.h"

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
  const AreaLight light(Spectrum(Rgb{5, 4, 3}));
  EXPECT_FALSE(light.IsDelta());
  EXPECT_EQ(light.Emitted({}, {0, 0, 1}).ToRgb(), (Rgb{5, 4, 3}));
  EXPECT_EQ(light.Emitted({}, {0, 0.6f, -0.8f}).ToRgb(), (Rgb{5, 4, 3}));
}

TEST(AreaLight, NeedsASurfaceToShineFrom) {
  Diagnostics diagnostics;
  CreateLight({"area", {}, {}}, {Transform(), false}, &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), ElementsAre(HasSubstr("needs an object in its node")));
}

TEST(LightsWithoutExtent, AreNotSeenByRays) {
  EXPECT_TRUE(PointLight({0, 0, 0}, {1, 1, 1}, 1).Emitted({}, {0, 0, 1}).IsBlack());
  EXPECT_TRUE(DirectionalLight({0, 0, 1}, {1, 1, 1}).Emitted({}, {0, 0, 1}).IsBlack());
}

}  // namespace
}  // namespace candela
