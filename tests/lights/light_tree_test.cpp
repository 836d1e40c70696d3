#include "lights/light_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

#include "lights/directional_light.h"
#include "lights/light_picker.h"
#include "lights/point_light.h"
#include "math/elementary.h"
#include "sampling/warp.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

LightReach Reach(Vec3 center, float power, float radius = 0) {
  LightReach reach;
  reach.center = center;
  reach.power = power;
  reach.radius = radius;
  return reach;
}

Vec3 PointIn(UniformNumbers* numbers) {
  const Vec2 xy = numbers->NextPair();
  return {xy.x * 4 - 2, xy.y * 4 - 2, numbers->Next() * 4 - 2};
}

/// Lamps of all kinds in a cube of side 4: round ones, spots, flat ones of one and of two sides.
std::vector<LightReach> Mixed(uint32_t count) {
  UniformNumbers numbers(7);
  std::vector<LightReach> lights;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 center = PointIn(&numbers);
    const float u = numbers.Next();
    LightReach reach = Reach(center, 0.01f + u * u * u * 10, i % 3 == 0 ? 0.05f : 0);
    if (i % 4 != 0) reach.axis = SampleUniformSphere(numbers.NextPair());
    if (i % 4 == 1) reach.least_cosine = 2 * numbers.Next() - 1;
    if (i % 4 >= 2) reach.is_flat = true;
    if (i % 4 == 2) reach.least_cosine = 0;
    lights.push_back(reach);
  }
  return lights;
}

/// Whether light of a lamp comes to a point, by what is known of it and with a margin for rounding.
bool ShinesAt(const LightReach& light, Vec3 p) {
  if (light.axis == Vec3()) return true;
  const Vec3 way = p - light.center;
  const float cosine = Dot(way, light.axis) / Length(way);
  return light.is_flat && light.least_cosine < 0 ? std::abs(cosine) > 1e-3f
                                                 : cosine > light.least_cosine + 1e-3f;
}

class LightTreeOf : public testing::TestWithParam<uint32_t> {};

INSTANTIATE_TEST_SUITE_P(Counts, LightTreeOf, testing::Values(1, 2, 3, 50, 3000));

TEST_P(LightTreeOf, ProbabilitiesSumToOneEverywhere) {
  const LightTree tree(Mixed(GetParam()));
  UniformNumbers numbers(1);
  for (int i = 0; i < 50; ++i) {
    // Within, and far outside.
    const Vec3 p = PointIn(&numbers) * (i % 5 == 4 ? 1000.0f : 1.0f);
    double sum = 0;
    for (uint32_t light = 0; light < GetParam(); ++light) {
      sum += static_cast<double>(tree.Probability(p, light));
    }
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

// P1
TEST_P(LightTreeOf, ChoosesAsOftenAsItsProbabilitySays) {
  const LightTree tree(Mixed(GetParam()));
  for (const Vec3 p : {Vec3{0.1f, 0.2f, 0.3f}, Vec3{5, 1, 0}}) {
    std::vector<double> shares;
    for (uint32_t i = 0; i < GetParam(); ++i) {
      shares.push_back(static_cast<double>(tree.Probability(p, i)));
    }
    UniformNumbers numbers(2);
    std::vector<uint64_t> counts(GetParam());
    for (int i = 0; i < 1000000; ++i) {
      const LightTree::Pick pick = tree.Choose(p, double{numbers.Next()});
      ASSERT_EQ(pick.probability, tree.Probability(p, pick.light));
      ASSERT_GT(pick.probability, 0);
      ++counts[pick.light];
    }
    if (std::count_if(shares.begin(), shares.end(), [](double s) { return s * 1e6 >= 5; }) > 1) {
      EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
    }
  }
}

TEST_P(LightTreeOf, NoLightThatReachesAPointIsNeverChosen) {
  const std::vector<LightReach> lights = Mixed(GetParam());
  const LightTree tree(lights);
  UniformNumbers numbers(3);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = PointIn(&numbers) * (i % 2 == 0 ? 1.0f : 3.0f);
    for (uint32_t light = 0; light < lights.size(); ++light) {
      if (ShinesAt(lights[light], p)) {
        ASSERT_GT(tree.Probability(p, light), 0) << light;
      }
    }
  }
}

// The near one of a thousand lamps, though all are alike; large parts blur where they are.
TEST(LightTree, PrefersWhatIsNear) {
  std::vector<LightReach> lights;
  for (int i = 0; i < 1000; ++i) lights.push_back(Reach({static_cast<float>(i), 0, 0}, 1));
  const LightTree tree(lights);
  EXPECT_GT(tree.Probability(Vec3{500, 0.1f, 0}, 500), 0.2f);
}

TEST(LightTree, LeavesOutWhatShinesTheOtherWay) {
  std::vector<LightReach> lights;
  for (int i = 0; i < 100; ++i) {
    LightReach reach = Reach({static_cast<float>(i % 10), 0, static_cast<float>(i / 10)}, 1);
    reach.axis = {0, i < 50 ? 1.0f : -1.0f, 0};
    reach.is_flat = true;
    reach.least_cosine = 0;
    lights.push_back(reach);
  }
  const LightTree tree(lights);
  double above = 0;
  for (uint32_t i = 0; i < 50; ++i)
    above += static_cast<double>(tree.Probability(Vec3{5, 30, 5}, i));
  EXPECT_GT(above, 0.999);
  for (uint32_t i = 50; i < 100; ++i) EXPECT_EQ(tree.Probability(Vec3{5, 30, 5}, i), 0) << i;
}

/// The time that a tree of so many lights at these places takes.
double SecondsFor(uint32_t count, const std::function<Vec3(uint32_t)>& place) {
  std::vector<LightReach> lights;
  for (uint32_t i = 0; i < count; ++i) lights.push_back(Reach(place(i), 1));
  const auto start = std::chrono::steady_clock::now();
  const LightTree tree(lights);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_GT(tree.Probability(Vec3{1, 2, 3}, count - 1), 0);
  return time.count();
}

// All in one place, each half as far as the one before, or on a line: a step for each lamp with all
// the others would take minutes.
TEST(LightTree, TakesAShortTimeHoweverTheLightsLie) {
  constexpr uint32_t kCount = 100000;
  EXPECT_LT(SecondsFor(kCount, [](uint32_t) { return Vec3{1, 1, 1}; }), 20);
  EXPECT_LT(SecondsFor(kCount,
                       [](uint32_t i) {
                         return Vec3{Exp2(-static_cast<float>(i % 120)), 0, 0};
                       }),
            20);
  EXPECT_LT(SecondsFor(kCount, [](uint32_t i) { return Vec3{static_cast<float>(i), 0, 0}; }), 20);
}

TEST(LightTree, StaysANumberWithTheLargestPlacesAndPowers) {
  const std::vector<LightReach> lights = {Reach({3e38f, 0, 0}, 1e30f), Reach({-3e38f, 0, 0}, 1e30f),
                                          Reach({0, 0, 0}, 1e-30f)};
  const LightTree tree(lights);
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{3e38f, 3e38f, 3e38f}, Vec3{1e-30f, 0, 0}}) {
    double sum = 0;
    for (uint32_t i = 0; i < 3; ++i) sum += static_cast<double>(tree.Probability(p, i));
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

// Beside the tree stand suns; together they are chosen by what they give, and no lamp is left out.
TEST(LightPickerOfMany, WeighsSunsAgainstTheTree) {
  std::vector<PointLight> lamps;
  for (int i = 0; i < 200; ++i) lamps.emplace_back(Vec3{0, 0, 0}, Rgb{1, 1, 1}, 1.0f);
  const DirectionalLight sun({0, -1, 0}, {200, 200, 200}), moon({0, -1, 0}, {100, 100, 100});
  std::vector<const Light*> lights = {&sun, &moon};
  for (const PointLight& lamp : lamps) lights.push_back(&lamp);
  const LightPicker picker(lights, 1, LightChoice::kByEffect);
  const LightPicker by_power(lights, 1, LightChoice::kByPower);
  const auto expected = [&](float share, uint32_t light) {
    return 0.9f * share + 0.1f * by_power.Probability(Vec3(), light);
  };
  // All lamps together have the irradiance 200 at distance 1.
  EXPECT_NEAR(picker.Probability(Vec3{1, 0, 0}, 0), expected(0.4f, 0), 1e-5);
  EXPECT_NEAR(picker.Probability(Vec3{1, 0, 0}, 1), expected(0.2f, 1), 1e-5);
  EXPECT_NEAR(picker.Probability(Vec3{1, 0, 0}, 2), expected(0.4f / 200, 2), 1e-5);
}

}  // namespace
}  // namespace candela
