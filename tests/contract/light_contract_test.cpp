// What holds for every light: those without extent are sampled, the others are surfaces that shine.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"
#include "tests/contract/rows.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using contract::SceneOfLight;
using test::UniformNumbers;

std::vector<LightEntry> Rows(bool are_delta) {
  std::vector<LightEntry> rows;
  for (const LightEntry& entry : LightEntries()) {
    if (SceneOfLight(entry.example)->lights()[0]->IsSurface() != are_delta) rows.push_back(entry);
  }
  return rows;
}

std::vector<std::string_view> Names(const std::vector<LightEntry>& rows) {
  std::vector<std::string_view> names;
  for (const LightEntry& entry : rows) names.push_back(entry.name);
  return names;
}

// Which of the two sets of tests below applies to whom.
TEST(LightContract, TheseRowsHaveNoExtent) {
  EXPECT_THAT(Names(Rows(true)), testing::ElementsAre("point", "directional", "spot"));
  EXPECT_THAT(Names(Rows(false)), testing::ElementsAre("area"));
}

bool IsRadiance(const Spectrum& radiance) {
  for (int c = 0; c < 4; ++c) {
    if (!std::isfinite(radiance[c]) || radiance[c] < 0) return false;
  }
  return true;
}

class EveryDeltaLight : public testing::TestWithParam<LightEntry> {
 protected:
  const std::unique_ptr<const Scene> scene_ = SceneOfLight(GetParam().example);
  const Light& light_ = *scene_->lights()[0];
  UniformNumbers random_{5};
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryDeltaLight, testing::ValuesIn(Rows(true)),
                         contract::RowName<LightEntry>);

TEST_P(EveryDeltaLight, SendsFiniteLightFromAUnitDirection) {
  int lit = 0;
  for (int i = 0; i < 10000; ++i) {
    const float distance = std::ldexp(1.0f, i % 40 - 20);
    const Vec3 p = SampleUniformSphere(random_.NextPair()) * distance;
    const LightSample sample = light_.SampleIncident(p);
    ASSERT_NEAR(Length(sample.direction), 1, 1e-6);
    ASSERT_TRUE(IsRadiance(sample.radiance));
    ASSERT_GT(sample.distance, 0.0f);
    ASSERT_EQ(sample.pdf, 1.0f);
    lit += !sample.radiance.IsBlack();
    const LightSample drawn = light_.SampleIncident(p, random_.NextPair());
    ASSERT_EQ(drawn.direction, sample.direction) << "there is nothing to draw";
    ASSERT_EQ(drawn.radiance, sample.radiance);
  }
  EXPECT_GT(lit, 100) << "it has no power";
  EXPECT_GT(light_.Reach().power, 0.0f);
}

// From two points the light is seen in the same place: where the two directions meet, or infinitely
// far.
TEST_P(EveryDeltaLight, IsInOnePlace) {
  const Vec3 p{3, -1, 2}, q{-2, 5, 1};
  const LightSample from_p = light_.SampleIncident(p), from_q = light_.SampleIncident(q);
  if (from_p.distance == std::numeric_limits<float>::max()) {
    EXPECT_EQ(from_p.direction, from_q.direction);
    EXPECT_EQ(from_q.distance, from_p.distance);
    return;
  }
  const Vec3 place = p + from_p.direction * from_p.distance;
  EXPECT_LT(Length(place - (q + from_q.direction * from_q.distance)), 1e-5f);
}

TEST_P(EveryDeltaLight, IsNotSeenByRays) {
  EXPECT_TRUE(light_.Emitted({}, {0, 0, 1}).IsBlack());
  EXPECT_EQ(scene_->objects()[0].light, SceneObject::kNoLight);
}

class EveryAreaLight : public testing::TestWithParam<LightEntry> {
 protected:
  const std::unique_ptr<const Scene> scene_ = SceneOfLight(GetParam().example);
  const Light& light_ = *scene_->lights()[0];
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryAreaLight, testing::ValuesIn(Rows(false)),
                         contract::RowName<LightEntry>);

TEST_P(EveryAreaLight, ShinesFromTheSurfaceOfItsNode) {
  ASSERT_EQ(scene_->objects()[0].light, 0u);
  const Ray ray({0, 0, 5}, {0, 0, -1});
  HitRecord hit;
  ASSERT_TRUE(scene_->Intersect(ray, &hit));
  const Spectrum emitted = light_.Emitted(scene_->SurfaceAt(ray, hit), -ray.direction);
  EXPECT_TRUE(IsRadiance(emitted));
  EXPECT_FALSE(emitted.IsBlack()) << "it has no power";
}

// P2: what a sample says of the light is what a ray in its direction finds.
TEST_P(EveryAreaLight, SamplesAgreeWithRays) {
  UniformNumbers random(6);
  int found = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p = SampleUniformSphere(random.NextPair()) * (1.01f + 5 * random.Next());
    const LightSample sample = light_.SampleIncident(p, random.NextPair());
    ASSERT_GT(sample.pdf, 0.0f);
    Ray ray(p, sample.direction);
    ray.t_max = sample.distance;
    ASSERT_FALSE(scene_->Occluded(ray)) << "the light hides itself";
    HitRecord hit;
    if (!scene_->Intersect(ray, &hit)) continue;  // At the very rim.
    ++found;
    const SurfacePoint seen = scene_->SurfaceAt(ray, hit);
    ASSERT_EQ(light_.Emitted(seen, -ray.direction), sample.radiance);
    ASSERT_NEAR(light_.PdfIncident(p, seen, ray.direction) / sample.pdf, 1, 1e-5);
  }
  EXPECT_GT(found, 9900);
  EXPECT_GT(light_.Reach().power, 0.0f);
}

// P1: over the cone around the ball that the light says it lies in. The shares are integrals of the
// density over what rays find in the direction of each cell.
TEST_P(EveryAreaLight, DirectionsFollowTheDensity) {
  constexpr size_t kRings = 12, kSectors = 24;
  constexpr int kSteps = 24, kSamples = 1000000;
  const LightReach reach = light_.Reach();
  for (const float distance : {1.5f, 4.0f, 30.0f}) {
    SCOPED_TRACE(distance);
    const Vec3 away = Normalize(Vec3{1, 2, -2});
    const Vec3 p = reach.center + away * (distance * reach.radius);
    const Frame frame = Frame::FromNormal(-away);
    // Cells of equal solid angle: heights above the rim of the cone, as parts of 1 - cosine.
    const double sine = 1.0001 / static_cast<double>(distance);
    const double rim = sine * sine / (1 + std::sqrt(1 - sine * sine));
    std::vector<double> shares(kRings * kSectors);
    double sum = 0;
    for (size_t cell = 0; cell < shares.size(); ++cell) {
      for (int i = 0; i < kSteps * kSteps; ++i) {
        const double ring = static_cast<double>(cell / kSectors) + (i / kSteps + 0.5) / kSteps;
        const double sector = static_cast<double>(cell % kSectors) + (i % kSteps + 0.5) / kSteps;
        const Vec3 w = frame.ToWorld(
            SampleCone({static_cast<float>(ring / kRings), static_cast<float>(sector / kSectors)},
                       static_cast<float>(rim)));
        const Ray ray(p, w);
        HitRecord hit;
        if (!scene_->Intersect(ray, &hit)) continue;
        const float pdf = light_.PdfIncident(p, scene_->SurfaceAt(ray, hit), w);
        shares[cell] += static_cast<double>(pdf) / (kSteps * kSteps);
      }
      shares[cell] *= 2 * kPi * rim / static_cast<double>(shares.size());
      sum += shares[cell];
    }
    EXPECT_NEAR(sum, 1, 2e-3) << "the integral of the density";
    for (double& share : shares) share /= sum;

    UniformNumbers random(8);
    std::vector<uint64_t> counts(shares.size());
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 w = light_.SampleIncident(p, random.NextPair()).direction;
      const Vec2 place = InvertCone(frame.ToLocal(w), static_cast<float>(rim));
      const auto index = [](float position, size_t size) {
        const double at = static_cast<double>(position) * static_cast<double>(size);
        return std::min(static_cast<size_t>(std::max(at, 0.0)), size - 1);
      };
      ++counts[index(place.x, kRings) * kSectors + index(place.y, kSectors)];
    }
    EXPECT_LT(test::ChiSquareDeviate(counts, shares), test::kLargestDeviate);
  }
}

TEST_P(EveryAreaLight, HasNoMiddle) {
  EXPECT_TRUE(light_.SampleIncident({3, 4, 5}).radiance.IsBlack());
}

}  // namespace
}  // namespace candela
