#include "lights/light_picker.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "lights/area_light.h"
#include "lights/directional_light.h"
#include "lights/point_light.h"
#include "lights/spot_light.h"
#include "math/elementary.h"
#include "shapes/disk.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

/// Point lights along the x axis, of growing power; every fifth one is dark. A sun, and a lamp
/// without a surface to draw from.
class LightPickerTest : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    for (int i = 0; i < GetParam(); ++i) {
      const float power = i % 5 == 4 ? 0 : 1 + static_cast<float>(i);
      owned_.push_back(std::make_unique<PointLight>(Vec3{static_cast<float>(i), 1, 0},
                                                    Rgb{power, power, power}, 1.0f));
    }
    owned_.push_back(std::make_unique<DirectionalLight>(Vec3{0, -1, 0}, Rgb{1, 2, 3}));
    owned_.push_back(std::make_unique<AreaLight>(Spectrum(1), true));
    for (const auto& light : owned_) lights_.push_back(light.get());
  }

  std::vector<std::unique_ptr<Light>> owned_;
  std::vector<const Light*> lights_;
};

// Few, which are looked at one by one, and many.
INSTANTIATE_TEST_SUITE_P(Counts, LightPickerTest, testing::Values(0, 1, 8, 100, 200, 2000));

// P1
TEST_P(LightPickerTest, ChoosesAsOftenAsItsProbabilitySays) {
  for (const LightChoice choice :
       {LightChoice::kByEffect, LightChoice::kUniform, LightChoice::kByPower}) {
    const LightPicker picker(lights_, 10, choice);
    const Vec3 p{2.2f, 0.1f, 0.3f};
    std::vector<double> shares;
    double sum = 0;
    for (uint32_t i = 0; i < lights_.size(); ++i) {
      shares.push_back(static_cast<double>(picker.Probability(p, i)));
      sum += shares.back();
    }
    EXPECT_NEAR(sum, 1, 1e-5);
    UniformNumbers numbers(1);
    std::vector<uint64_t> counts(lights_.size());
    for (int i = 0; i < 1000000; ++i) {
      const LightPicker::Pick pick = picker.Choose(p, numbers.Next());
      ASSERT_EQ(pick.probability, picker.Probability(p, pick.light));
      ++counts[pick.light];
    }
    if (GetParam() > 0) {
      EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
    }
    EXPECT_EQ(counts.back(), 0u) << "of this one nothing can be drawn";
  }
}

TEST_P(LightPickerTest, EveryLightWithPowerMayBeChosenAnywhere) {
  const LightPicker picker(lights_, 10, LightChoice::kByEffect);
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{3, 1, 0}, Vec3{1e10f, 0, 0}, Vec3{-1e-10f, 1, 1}}) {
    for (uint32_t i = 0; i < lights_.size(); ++i) {
      EXPECT_EQ(picker.Probability(p, i) > 0, lights_[i]->Reach().power > 0) << i;
    }
  }
}

// Beside one of two equal lamps it is chosen more often than the far one.
TEST(LightPicker, PrefersWhatIsNear) {
  const PointLight left({-1, 0, 0}, {1, 1, 1}, 1), right({1, 0, 0}, {1, 1, 1}, 1);
  const LightPicker picker(std::vector<const Light*>{&left, &right}, 1, LightChoice::kByEffect);
  EXPECT_FLOAT_EQ(picker.Probability(Vec3{0, 5, 0}, 0), 0.5f);
  EXPECT_FLOAT_EQ(picker.Probability(Vec3{0.5f, 0, 0}, 1), 0.8f * 0.9f + 0.2f * 0.5f);
}

/// Far enough from both, it is by the beam that they differ.
TEST(LightPicker, LeavesASpotOutOfWhoseBeamThePointIs) {
  const PointLight all_around({0, 0, 0}, {1, 1, 1}, 1);
  const SpotLight spot({0, 0, 0}, {{0, 0, -1}, 0.95f, 0.9f}, {1, 1, 1}, 1);
  const LightPicker picker(std::vector<const Light*>{&all_around, &spot}, 1,
                           LightChoice::kByEffect);
  EXPECT_FLOAT_EQ(picker.Probability(Vec3{0, 0, -5}, 1), 0.5f);
  EXPECT_FLOAT_EQ(picker.Probability(Vec3{0, 4, -3}, 1), 0.1f) << "every light keeps a part";
}

// A lamp of one side is left out behind it, and fades towards its plane; the ball around it blurs
// that.
TEST(LightPicker, KnowsWhichWayAFlatLampShines) {
  const Disk disk(0.01f);
  const PointLight other({0, 0, 0}, {1, 1, 1}, 1);
  AreaLight lamp(Spectrum(10000 / static_cast<float>(kPi)),
                 false);  // Intensity 1 along its normal.
  lamp.SetSurface(disk.MakeSampler(Transform(), Transform()), {}, 0.01f);
  const LightPicker picker(std::vector<const Light*>{&other, &lamp}, 1, LightChoice::kByEffect);
  EXPECT_NEAR(picker.Probability(Vec3{0, 0, 5}, 1), 0.5f, 1e-3);
  EXPECT_NEAR(picker.Probability(Vec3{3, 0, 4}, 1), 0.8f * 0.8f / 1.8f + 0.1f, 1e-3);
  EXPECT_FLOAT_EQ(picker.Probability(Vec3{0, 0, -5}, 1), 0.1f);
}

TEST(LightPicker, HasNothingToChooseFromInTheDark) {
  const PointLight dark({0, 0, 0}, {0, 0, 0}, 1);
  EXPECT_FALSE(LightPicker({}, 1, LightChoice::kByEffect).HasLights());
  const std::vector<const Light*> lights = {&dark};
  EXPECT_FALSE(LightPicker(lights, 1, LightChoice::kByEffect).HasLights());
}

// What is bright at hand is as bright as the lamp of an attenuation, however little of its falloff
// is quadratic: effects do not go by that part, nor do the shares that many lights have.
TEST(LightPicker, SmallQuadraticPartsOfAFalloffDoNotStarveOthers) {
  for (const uint32_t count : {40u, 200u}) {
    for (const Falloff falloff : {Falloff(1, 0.1f, 0.001f), Falloff(1, 0, 1e-5f)}) {
      std::vector<PointLight> lamps(count, PointLight({0, 1, 0}, {1, 1, 1}, falloff));
      lamps.emplace_back(Vec3{1, 1, 0}, Rgb{1, 1, 1}, 1.0f);
      std::vector<const Light*> lights;
      for (const PointLight& lamp : lamps) lights.push_back(&lamp);
      const LightPicker picker(lights, 10, LightChoice::kByEffect);
      // As far from all of them; of many, a tenth of the choice goes by shares.
      const float even = 1 / static_cast<float>(count + 1);
      const float share = LightPicker(lights, 10, LightChoice::kByPower).Probability({}, count);
      EXPECT_NEAR(share, 1.5f * even, 0.6f * even);
      const float expected = count > LightPicker::kFew ? 0.9f * even + 0.1f * share : even;
      EXPECT_NEAR(picker.Probability(Vec3{0.5f, 0, 0}, count), expected, 0.1f / (count + 1));
    }
  }
}

TEST(LightPicker, LampsOfAnyFalloffMayBeChosen) {
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_GT(PointLight({}, {1, 1, 1}, {kMost, kMost, 1}).Reach().power, 0);
}

}  // namespace
}  // namespace candela
