#include "lights/projector_light.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "math/elementary.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

/// Red grows to the right, green upwards; blue is the same everywhere.
class Gradient final : public Texture {
 public:
  Rgb Lookup(const SurfacePoint& point) const override { return {point.uv.x, point.uv.y, 0.5f}; }
};

ColorInput MakeGradient() {
  const Rgb most{10, 10, 10};
  return ColorInput(std::make_shared<const Gradient>(), -most, most);
}

/// From the origin along -z, 4 wide and 2 high at distance 1. In the middle a white picture would
/// have the intensity 4.
ProjectorLight Projector() {
  return {{0, 0, 0}, {{0, 0, -3}, {0, 2, -1}, {2, 1}}, MakeGradient(), {8, 8, 8}, 2};
}

/// What a screen across the direction at a distance of 2 gets in a place of the picture.
Rgb OnScreen(float x, float y) {
  const LightSample sample = Projector().SampleIncident({4 * x, 2 * y, -2});
  return sample.radiance.ToRgb() * std::abs(sample.direction.z);
}

// color / (attenuation D^2) = 1 times the picture, in the corners as in the middle.
TEST(ProjectorLight, ThrowsItsPictureEvenly) {
  for (const float x : {-0.9f, -0.25f, 0.0f, 0.5f, 0.99f}) {
    for (const float y : {-0.9f, 0.0f, 0.75f}) {
      const Rgb light = OnScreen(x, y);
      EXPECT_NEAR(light.x, (x + 1) / 2, 1e-5f);
      EXPECT_NEAR(light.y, (y + 1) / 2, 1e-5f);
      EXPECT_NEAR(light.z, 0.5f, 1e-5f);
    }
  }
}

TEST(ProjectorLight, IsDarkAroundItsPictureAndBehind) {
  EXPECT_EQ(OnScreen(1.01f, 0), Rgb());
  EXPECT_EQ(OnScreen(0, -1.01f), Rgb());
  EXPECT_TRUE(Projector().SampleIncident({0, 0, 2}).radiance.IsBlack());
}

// The integral of the intensity over solid angle: the area at distance 1, 8, times 4, times the
// mean of the picture, 1/2.
TEST(ProjectorLight, HasThePowerOfItsPicture) {
  EXPECT_NEAR(Projector().Power({}), 16, 1e-4f);
}

TEST(ProjectorLight, SendsOutWhatArrives) {
  const ProjectorLight projector = Projector();
  for (int i = 0; i < 1000; ++i) {
    const Vec2 u{(static_cast<float>(i % 40) + 0.5f) / 40,
                 (static_cast<float>(i / 40) + 0.5f) / 25};
    const EmissionSample sent = projector.SampleEmission({}, {}, u);
    const LightSample seen = projector.SampleIncident(sent.direction);
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(sent.flux[c] * sent.pdf_direction, seen.radiance[c],
                  1e-4f * (1 + seen.radiance[c]));
    }
  }
}

TEST(ProjectorLight, SendsNothingBelowBlack) {
  const ProjectorLight dark({}, {{0, 0, -1}, {0, 1, 0}, {1, 1}}, Rgb{-1, -1, -1}, {1, 1, 1}, 1);
  EXPECT_EQ(dark.SampleIncident({0, 0, -1}).radiance.ToRgb(), Rgb());
}

// Turned by its node, with the picture's aspect and angle.
TEST(ProjectorLight, IsMadeByScenes) {
  const auto scene = testing_support::CompileText(
      std::string(testing_support::kCamera) +
      "Textures { Texture { name slide type checker even 1 0 0 odd 0 1 0 scale 2 1 } }\n"
      "Scene { Node { Transform { translate 0 5 0 z_rotate 90 }\n"
      "Component<Light> { type projector image texture slide direction -1 0 0 up 0 0 -1 fov 90\n"
      "aspect 2 attenuation 0.04 } } }");
  ASSERT_TRUE(scene);
  const Light& light = *scene->lights()[0];
  // It looks down; up is -z, so its right is +x.
  EXPECT_EQ(light.SampleIncident({-1, 0, 0}).radiance.ToRgb().y, 0);
  EXPECT_GT(light.SampleIncident({-1, 0, 0}).radiance.ToRgb().x, 0.9f);
  EXPECT_GT(light.SampleIncident({1, 0, 0}).radiance.ToRgb().y, 0.9f);
  EXPECT_FALSE(light.SampleIncident({9.9f, 0, 4.9f}).radiance.IsBlack());
  EXPECT_TRUE(light.SampleIncident({10.1f, 0, 0}).radiance.IsBlack());
  EXPECT_TRUE(light.SampleIncident({0, 0, 5.1f}).radiance.IsBlack());
}

// A mirrored node shows the mirrored picture: left and right change places, as those of the node
// do.
TEST(ProjectorLight, IsMirroredWithItsNode) {
  const auto left_is_red = [](const std::string& transform) {
    const auto scene = testing_support::CompileText(fmt::format(
        "{}Textures {{ Texture {{ name slide type checker even 1 0 0 odd 0 1 0 scale 2 1 }} }}\n"
        "Scene {{ Node {{ Transform {{ {} }}\n"
        "Component<Light> {{ type projector image texture slide direction 0 0 -1 up 0 1 0 fov 90\n"
        "attenuation 0.04 }} }} }}",
        testing_support::kCamera, transform));
    const Rgb left = scene->lights()[0]->SampleIncident({-0.3f, 0, -1}).radiance.ToRgb();
    const Rgb right = scene->lights()[0]->SampleIncident({0.3f, 0, -1}).radiance.ToRgb();
    EXPECT_EQ(left.x == 0, left.y > 0) << transform;
    EXPECT_NE(left.x > 0, right.x > 0) << transform;
    return left.x > 0;
  };
  EXPECT_TRUE(left_is_red("scale 1 1 1"));
  EXPECT_FALSE(left_is_red("scale -1 1 1"));
  // What is up follows the node anyway; here it goes down, and red stays on the left.
  EXPECT_TRUE(left_is_red("scale 1 -1 1"));
  EXPECT_FALSE(left_is_red("scale -1 -1 1"));
}

/// White; counts how often it is asked.
class Counted final : public Texture {
 public:
  explicit Counted(int* lookups) : lookups_(lookups) {}
  Rgb Lookup(const SurfacePoint&) const override {
    ++*lookups_;
    return {1, 1, 1};
  }

 private:
  int* lookups_;
};

TEST(ProjectorLight, LooksAtItsPictureWhenThePowerIsAskedFor) {
  int lookups = 0;
  const Rgb most{1, 1, 1};
  const ProjectorLight projector({}, {{0, 0, -1}, {0, 1, 0}, {1, 1}},
                                 ColorInput(std::make_shared<const Counted>(&lookups), {}, most),
                                 {1, 1, 1}, 1);
  EXPECT_FALSE(projector.SampleIncident({0, 0, -1}).radiance.IsBlack());
  EXPECT_EQ(lookups, 1);
  EXPECT_NEAR(projector.Power({}), 4, 1e-5f);
  const int all = lookups;
  EXPECT_GT(all, 1000);
  EXPECT_NEAR(projector.Power({}), 4, 1e-5f);
  EXPECT_EQ(lookups, all);
}

}  // namespace
}  // namespace candela
