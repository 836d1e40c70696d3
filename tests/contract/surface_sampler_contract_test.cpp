// What holds for every shape that can be sampled as a light, in the world under each of a few
// transforms.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"
#include "tests/contract/rows.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/lines.h"

namespace candela {
namespace {

using contract::SceneOfShape;
using test::UniformNumbers;

std::unique_ptr<const SurfaceSampler> SamplerOf(const Scene& scene) {
  const SceneObject& object = scene.objects()[0];
  return object.shape->MakeSampler(object.world_from_object, object.object_from_world);
}

std::vector<ShapeEntry> Rows(bool have_sampler) {
  std::vector<ShapeEntry> rows;
  for (const ShapeEntry& entry : ShapeEntries()) {
    const auto scene = SceneOfShape(entry.example);
    if ((SamplerOf(*scene) != nullptr) == have_sampler) rows.push_back(entry);
  }
  return rows;
}

TEST(SurfaceSamplerContract, TheseShapesAreFoundByRaysAlone) {
  std::vector<std::string_view> names;
  for (const ShapeEntry& entry : Rows(false)) names.push_back(entry.name);
  EXPECT_THAT(names, testing::ElementsAre("plane"));
}

struct Placement {
  const char* name;
  const char* outer;
  const char* inner;
};

constexpr Placement kPlacements[] = {
    {"as it is", "", ""},
    {"moved and turned", "translate 10 -3 7 x_rotate 30 y_rotate -100", ""},
    {"stretched", "z_rotate 20", "scale 2 0.4 1"},
    {"sheared", "scale 2 1 1", "z_rotate 40"},
    {"mirrored", "scale -1 1 1", "translate 1 2 3 x_rotate 12"},
    {"small", "", "scale 0.01 0.01 0.01"},
};

class EverySampledShape : public testing::TestWithParam<ShapeEntry> {
 protected:
  template <class Check>
  void ForPlacements(Check&& check) {
    for (const Placement& placement : kPlacements) {
      SCOPED_TRACE(placement.name);
      const auto scene = SceneOfShape(GetParam().example, placement.outer, placement.inner);
      const auto sampler = SamplerOf(*scene);
      ASSERT_TRUE(sampler);
      check(*scene, *sampler, scene->Bounds());
    }
  }

  /// Somewhere around the box, from near to a few times its size away.
  Vec3 PointAround(const Bounds3& box) {
    const Vec3 side = SampleUniformSphere(random_.NextPair());
    return box.Center() + side * (Length(box.Extent()) * (0.3f + 2 * random_.Next()));
  }

  UniformNumbers random_{3};
};

INSTANTIATE_TEST_SUITE_P(Registry, EverySampledShape, testing::ValuesIn(Rows(true)),
                         contract::RowName<ShapeEntry>);

// A ray along the sampled direction meets the surface there, just behind the distance, unless
// something of it lies before.
TEST_P(EverySampledShape, SampledDirectionsReachTheSurface) {
  ForPlacements([this](const Scene& scene, const SurfaceSampler& sampler, const Bounds3& box) {
    int reached = 0, hidden = 0, beside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 from = PointAround(box);
      const SurfaceSample sample = sampler.Sample(from, random_.NextPair());
      if (sample.pdf == 0) continue;
      ASSERT_TRUE(sample.pdf > 0 && std::isfinite(sample.pdf));
      ASSERT_NEAR(Length(sample.direction), 1, 1e-6);
      ASSERT_NEAR(Length(sample.n), 1, 1e-6);
      Ray ray(from, sample.direction);
      ray.t_max = sample.distance;
      if (scene.Occluded(ray)) {
        ++hidden;
        continue;
      }
      HitRecord hit;
      // At the very rim a ray may miss by rounding.
      if (!scene.Intersect(ray, &hit)) continue;
      ++reached;
      const float cosine = std::abs(Dot(sample.n, sample.direction));
      const float scale = hit.t + Length(from) + Length(box.Extent());
      ASSERT_NEAR(hit.t, sample.distance, 1e-4f * scale / (cosine + 0.01f));
      if (cosine < 0.05f) continue;
      const SurfacePoint point = scene.SurfaceAt(ray, hit);
      if (Dot(point.n_geometric, sample.n) < 0.99f) {
        ++beside;
        continue;
      }
      ASSERT_NEAR(sampler.Pdf(from, point.p, point.n_geometric) / sample.pdf, 1, 0.01 / cosine);
    }
    EXPECT_GT(reached, 5000);
    EXPECT_LT(beside, 5) << "only at an edge may rounding lead to a neighbour";
    if (GetParam().name != "mesh") {
      EXPECT_LT(hidden, 20);
    }
  });
}

// P2: the density over all directions in which the surface is seen is the share of samples that are
// seen: 1 for a shape that hides nothing of itself.
TEST_P(EverySampledShape, DensityIntegratesToTheShareOfSamplesThatAreSeen) {
  ForPlacements([this](const Scene& scene, const SurfaceSampler& sampler, const Bounds3& box) {
    for (int view = 0; view < 4; ++view) {
      // Outside of the ball around the box, whose cone holds all that is seen.
      const float radius = Length(box.Extent()) / 2;
      const Vec3 side = SampleUniformSphere(random_.NextPair());
      const float distance = radius * (1.2f + static_cast<float>(view));
      const Vec3 from = box.Center() + side * distance;
      const float sine = radius / distance * 1.001f;
      const float one_minus_cosine = 1 - std::sqrt(1 - sine * sine);
      const Frame frame = Frame::FromNormal(-side);
      constexpr int kCount = 40000;
      double sum = 0, squares = 0;
      int seen = 0, drawn = 0;
      for (int i = 0; i < kCount; ++i) {
        const Vec3 w = frame.ToWorld(SampleCone(random_.NextPair(), one_minus_cosine));
        const Ray ray(from, w);
        HitRecord hit;
        if (scene.Intersect(ray, &hit)) {
          const SurfacePoint point = scene.SurfaceAt(ray, hit);
          const double value = static_cast<double>(sampler.Pdf(from, point.p, point.n_geometric)) /
                               static_cast<double>(ConePdf(one_minus_cosine));
          sum += value;
          squares += value * value;
        }
        const SurfaceSample sample = sampler.Sample(from, random_.NextPair());
        if (sample.pdf == 0) continue;
        ++drawn;
        Ray shadow(from, sample.direction);
        shadow.t_max = sample.distance;
        seen += !scene.Occluded(shadow);
      }
      ASSERT_GT(drawn, kCount / 2);
      const double integral = sum / kCount;
      const double share = static_cast<double>(seen) / kCount;
      const double variance =
          (squares / kCount - integral * integral + share * (1 - share)) / kCount;
      EXPECT_LT(std::abs(integral - share), test::kLargestDeviate * std::sqrt(variance) + 1e-3)
          << "from " << from.x << " " << from.y << " " << from.z;
    }
  });
}

// P13: of lines in all directions, a surface is met by half its area over the area that the lines
// go through, on the mean; so its area can be counted.
TEST_P(EverySampledShape, AreaIsWhatLinesFind) {
  ForPlacements([this](const Scene& scene, const SurfaceSampler& sampler, const Bounds3& box) {
    constexpr int kLines = 100000;
    const float radius = Length(box.Extent()) / 2 * 1.001f;
    double sum = 0, squares = 0;
    for (int i = 0; i < kLines; ++i) {
      const Vec2 u_direction = random_.NextPair();
      const Ray line =
          testing_support::LineThroughBall(box.Center(), radius, u_direction, random_.NextPair());
      const int count = testing_support::FollowLine(scene, line.origin, line.direction).count;
      sum += count;
      squares += count * count;
    }
    const double disk = kPi * static_cast<double>(radius) * static_cast<double>(radius);
    const double mean = sum / kLines;
    const double error = std::sqrt((squares / kLines - mean * mean) / kLines);
    EXPECT_NEAR(static_cast<double>(sampler.Area()), 2 * disk * mean,
                2 * disk * test::kLargestDeviate * error);
    EXPECT_LT(error, 0.02 * mean);
  });
}

// Scaled by 2, a surface has four times the area.
TEST_P(EverySampledShape, AreaGrowsWithTheSquareOfItsSize) {
  const auto plain = SceneOfShape(GetParam().example);
  const auto doubled = SceneOfShape(GetParam().example, "x_rotate 20", "scale 2 2 2");
  EXPECT_NEAR(SamplerOf(*doubled)->Area() / SamplerOf(*plain)->Area(), 4, 1e-5);
}

TEST_P(EverySampledShape, FromItsOwnSurfaceNothingStrangeIsDrawn) {
  ForPlacements([this](const Scene& scene, const SurfaceSampler& sampler, const Bounds3& box) {
    int hits = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec3 from = PointAround(box);
      const Vec3 target =
          box.min + box.Extent() * Vec3{random_.Next(), random_.Next(), random_.Next()};
      const Ray ray(from, Normalize(target - from));
      HitRecord hit;
      if (!scene.Intersect(ray, &hit)) continue;
      ++hits;
      const SurfacePoint point = scene.SurfaceAt(ray, hit);
      const SurfaceSample sample = sampler.Sample(point.p, random_.NextPair());
      ASSERT_TRUE(sample.pdf >= 0 && std::isfinite(sample.pdf));
      if (GetParam().name != "mesh") {
        ASSERT_EQ(sample.pdf, 0);
      }
    }
    EXPECT_GT(hits, 100);
  });
}

}  // namespace
}  // namespace candela
