#include "lights/falloff.h"

#include <gtest/gtest.h>

#include "lights/point_light.h"
#include "lights/spot_light.h"

namespace candela {
namespace {

/// What reaches the origin from a lamp of colour 1 so far above it.
float ReceivedFrom(float distance, Falloff falloff) {
  return PointLight({0, distance, 0}, {1, 1, 1}, falloff).SampleIncident({0, 0, 0}).radiance[0];
}

// 1 / (1 + 0.5 D + 0.25 D^2).
TEST(Falloff, IsConstantLinearAndQuadratic) {
  EXPECT_EQ(ReceivedFrom(2, {1, 0.5f, 0.25f}), 1 / 3.0f);
  EXPECT_EQ(ReceivedFrom(4, {1, 0.5f, 0.25f}), 1 / 7.0f);
  EXPECT_EQ(ReceivedFrom(8, {0, 0.5f, 0}), 0.25f);
  EXPECT_EQ(ReceivedFrom(8, {4, 0, 0}), 0.25f);
}

TEST(Falloff, OfTheSquareIsAnAttenuation) {
  for (const float distance : {0.1f, 3.0f, 1e3f, 1e19f}) {
    EXPECT_EQ(ReceivedFrom(distance, {0, 0, 0.3f}), ReceivedFrom(distance, 0.3f));
  }
}

// The square of such a distance is infinite.
TEST(Falloff, IsANumberHoweverFar) {
  EXPECT_EQ(ReceivedFrom(1e30f, {0, 0, 1}), 0);
  EXPECT_EQ(ReceivedFrom(1e30f, {2, 0, 0}), 0.5f);
  EXPECT_EQ(ReceivedFrom(1e30f, {2, 0, 1}), 0);
}

TEST(Falloff, HoldsForSpotsToo) {
  const SpotLight spot({0, 2, 0}, {{0, -1, 0}, 0.9f, 0.8f}, {3, 3, 3}, {1, 0.5f, 0.25f});
  EXPECT_EQ(spot.SampleIncident({0, 0, 0}).radiance[0], 1);
  EXPECT_FALSE(spot.CanBeSentOut());
}

// Only what falls with the squared distance is light that is sent out.
TEST(Falloff, OfOtherKindsIsNotSentOut) {
  const Ball ball{{0, 0, 0}, 1};
  EXPECT_TRUE(PointLight({}, {1, 1, 1}, {0, 0, 1}).CanBeSentOut());
  for (const Falloff falloff : {Falloff(1, 0, 1), Falloff(0, 1, 0)}) {
    const PointLight light({}, {1, 1, 1}, falloff);
    EXPECT_FALSE(light.CanBeSentOut());
    EXPECT_TRUE(light.SampleEmission(ball, {0.5f, 0.5f}, {0.5f, 0.5f}).flux.IsBlack());
    EXPECT_EQ(light.Power(ball), 0);
    EXPECT_GT(light.Reach().power, 0) << "it may be chosen";
  }
}

}  // namespace
}  // namespace candela
