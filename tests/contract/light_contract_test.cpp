// What holds for every light: those without extent are sampled, the others are surfaces that shine.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/spawn_ray.h"
#include "lights/environment_light.h"
#include "lights/even_sky_light.h"
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
  EXPECT_THAT(Names(Rows(true)),
              testing::ElementsAre("point", "directional", "spot", "projector", "ies"));
  EXPECT_THAT(Names(Rows(false)), testing::ElementsAre("area"));
}

bool IsRadiance(const Spectrum& radiance) {
  for (int c = 0; c < 4; ++c) {
    if (!std::isfinite(radiance[c]) || radiance[c] < 0) return false;
  }
  return true;
}

/// What light from the sky has to cover.
constexpr Ball kBall{{0, 0, 0}, 4};

/// The mean flux of emission is the power, in one percent and by the error of the mean; and each
/// sample is what the densities say of it.
void ExpectPower(const Light& light) {
  constexpr int kCount = 100000;
  UniformNumbers random(9);
  double sum = 0, squares = 0;
  int edges = 0;
  for (int i = 0; i < kCount; ++i) {
    const Vec2 u_position = random.NextPair();
    const Vec2 u_direction = random.NextPair();
    const EmissionSample sample = light.SampleEmission(kBall, u_position, u_direction);
    const double flux = static_cast<double>(MeanOf(sample.flux.ToRgb()));
    sum += flux;
    squares += flux * flux;
    if (flux == 0) continue;
    ASSERT_TRUE(IsRadiance(sample.flux));
    ASSERT_NEAR(Length(sample.direction), 1, 1e-6);
    const EmissionPdf pdf = light.PdfEmission(kBall, sample.origin, sample.direction);
    ASSERT_NEAR(pdf.position / sample.pdf_position, 1, 1e-5);
    // Where a grid of directions has an edge, rounding decides on the side.
    if (std::abs(pdf.direction / sample.pdf_direction - 1) > 1e-3f) ++edges;
    if (light.Kind() != LightKind::kSky && !light.Reach().is_far) continue;
    ASSERT_GE(Length(sample.origin.p), kBall.radius * 0.999f) << "it starts within the scene";
  }
  const double mean = sum / kCount;
  const double error = std::sqrt(std::max(0.0, squares / kCount - mean * mean) / kCount);
  const double power = static_cast<double>(light.Power(kBall));
  EXPECT_NEAR(mean, power, test::kLargestDeviate * error + 0.012 * power);
  EXPECT_LT(error, 0.02 * power);
  EXPECT_LT(edges, kCount / 1000);
}

/// Over the cells of a square below the light the flux of the rays that it sends out is the
/// irradiance that it gives there, by each colour. A lamp may hide parts of itself.
void ExpectSameLight(const Light& light, const Scene& scene) {
  constexpr int kCount = 400000, kSide = 4;
  constexpr float kHalf = 1.5f, kHeight = -2;
  struct Cell {
    double sent = 0, sent_squares = 0, arrived = 0, arrived_squares = 0;
  };
  Cell cells[kSide][kSide][3];
  UniformNumbers random(10);
  const auto cell_at = [&](Vec3 p) {
    const auto index = [](float x) {
      return static_cast<int>(std::floor((x / kHalf + 1) / 2 * kSide));
    };
    const int x = index(p.x), z = index(p.z);
    return x >= 0 && x < kSide && z >= 0 && z < kSide ? cells[x][z] : nullptr;
  };
  const float area = 4 * kHalf * kHalf;
  const bool may_hide = light.Kind() == LightKind::kSurface;
  for (int i = 0; i < kCount; ++i) {
    const Vec2 u_position = random.NextPair();
    const Vec2 u_direction = random.NextPair();
    const EmissionSample sent = light.SampleEmission(kBall, u_position, u_direction);
    const float t = (kHeight - sent.origin.p.y) / sent.direction.y;
    Ray leaving = SpawnRay(sent.origin, sent.direction);
    leaving.t_max = t;
    if (sent.direction.y < 0 && t > 0 && !(may_hide && scene.Occluded(leaving))) {
      if (Cell* cell = cell_at(sent.origin.p + sent.direction * t)) {
        for (int c = 0; c < 3; ++c) {
          const double flux = static_cast<double>(sent.flux[c]) / kCount;
          cell[c].sent += flux;
          cell[c].sent_squares += flux * flux;
        }
      }
    }
    const Vec2 place = random.NextPair();
    const Vec3 p{(2 * place.x - 1) * kHalf, kHeight, (2 * place.y - 1) * kHalf};
    const LightSample seen = light.SampleIncident(p, random.NextPair());
    if (seen.pdf == 0 || !(seen.direction.y > 0)) continue;
    Cell* cell = cell_at(p);
    for (int c = 0; c < 3 && cell; ++c) {
      const float irradiance = seen.radiance[c] * seen.direction.y / seen.pdf;
      const double flux = static_cast<double>(irradiance * area) / kCount;
      cell[c].arrived += flux;
      cell[c].arrived_squares += flux * flux;
    }
  }
  for (const auto& row : cells) {
    for (const auto& colours : row) {
      for (const Cell& cell : colours) {
        const double error = std::sqrt(cell.sent_squares + cell.arrived_squares);
        EXPECT_LT(std::abs(cell.sent - cell.arrived), test::kLargestDeviate * error + 1e-5);
        EXPECT_LE(error, 0.1 * cell.arrived);
      }
    }
  }
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

// What holds for both: light that is sent out, and light that arrives, are the same light.

class EveryLight : public testing::TestWithParam<LightEntry> {
 protected:
  const std::unique_ptr<const Scene> scene_ = SceneOfLight(GetParam().example);
  const Light& light_ = *scene_->lights()[0];
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryLight,
                         testing::ValuesIn(LightEntries().begin(), LightEntries().end()),
                         contract::RowName<LightEntry>);

TEST_P(EveryLight, SendsOutItsPower) {
  ExpectPower(light_);
}

TEST_P(EveryLight, SendsOutTheLightThatArrives) {
  ExpectSameLight(light_, *scene_);
}

// What is no row: surroundings, suns of an angle, lamps of other shapes and on one side.
TEST(Emission, OfOtherLightsIsTheLightThatArrives) {
  const char* lamps[] = {
      "Component<Light> { type directional direction 0.3 -1 0.2 color 1 2 3 angle 40 }",
      "Component<Object> { type sphere radius 0.5 } Component<Material> { index 0 } "
      "Transform { translate 0.5 1 0 scale 1 0.5 2 } Component<Light> { type area radiance 2 3 4 }",
      "Component<Object> { type rectangle width 1 height 2 } Component<Material> { index 0 } "
      "Transform { translate 0.3 0.5 0 x_rotate 75 } Component<Light> { type area radiance 2 3 4 "
      "two_sided false }",
      "Component<Object> { type disk radius 0.7 } Component<Material> { index 0 } "
      "Transform { translate 0.3 0.5 0 x_rotate -60 } Component<Light> { type area radiance 2 3 4 "
      "}",
      "Component<Light> { type spot direction 0.1 -1 0.1 angle 70 blend 0.8 attenuation 0.5 }"};
  for (const char* lamp : lamps) {
    SCOPED_TRACE(lamp);
    const auto scene = testing_support::CompileText(
        std::string(testing_support::kCamera) +
        "Materials { Material { type diffuse albedo 1 1 1 } } Scene { Node { " + lamp + " } }");
    ExpectPower(*scene->lights()[0]);
    ExpectSameLight(*scene->lights()[0], *scene);
  }
}

TEST(Emission, OfTheSkyIsTheLightThatArrives) {
  const auto environment = testing_support::CompileText(
      std::string(testing_support::kCamera) +
      "Background { environment assets/environments/sky.hdr scale 2 rotate 70 } Scene { }");
  const auto cube = testing_support::CompileText(
      std::string(testing_support::kCamera) +
      "Background { cube_map assets/assignment4/tex/rotunda } Scene { }");
  const auto day = testing_support::CompileText(
      std::string(testing_support::kCamera) +
      "Background { sky daylight turbidity 4 sun_elevation 25 sun_azimuth 200 } Scene { }");
  const EnvironmentLight map(*environment->background().environment);
  const EnvironmentLight faces(*cube->background().cube_map);
  const EnvironmentLight daylight(*day->background().environment);
  const EvenSkyLight even(Spectrum(Rgb{0.5f, 1, 2}));
  for (const Light* sky : std::initializer_list<const Light*>{&map, &faces, &daylight, &even}) {
    ExpectPower(*sky);
    ExpectSameLight(*sky, *cube);
  }
}

// What no sampler draws is said to be so; the integrator asks.
TEST(Emission, OfAPlaneIsFoundByHitsAlone) {
  const auto plane = testing_support::CompileText(
      std::string(testing_support::kCamera) +
      "Materials { Material { type diffuse albedo 1 1 1 } } Scene { Component<Object> { type plane "
      "normal 0 1 0 offset -1 } Component<Material> { index 0 } Component<Light> { type area "
      "radiance 1 1 1 } }");
  EXPECT_TRUE(plane->lights()[0]->IsFoundByHitsAlone());
  EXPECT_TRUE(plane->lights()[0]->SampleEmission(kBall, {}, {}).flux.IsBlack());
  EXPECT_FALSE(SceneOfLight("type area radiance 1 1 1")->lights()[0]->IsFoundByHitsAlone());
}

}  // namespace
}  // namespace candela
