// What holds for every shape that can be sampled as a light, in the world under each of a few
// transforms.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

#include "geometry/spawn_ray.h"
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

/// Which eighth of a box a point lies in.
size_t EighthOf(const Bounds3& box, Vec3 p) {
  const Vec3 center = box.Center();
  return size_t{p.x > center.x} + 2 * size_t{p.y > center.y} + 4 * size_t{p.z > center.z};
}

// Lines that cross a ball evenly cross each part of a surface as often as its area says (Crofton):
// the areas of the eighths of the shape, by such lines and by the density of drawn points.
TEST_P(EverySampledShape, PointsAreDrawnByTheirDensityOverArea) {
  ForPlacements([this](const Scene& scene, const SurfaceSampler& sampler, const Bounds3& box) {
    constexpr int kCount = 40000;
    const double radius = static_cast<double>(Length(box.Extent())) * 0.51;
    double by_lines[8] = {}, by_points[8] = {}, squares[8] = {};
    for (int i = 0; i < kCount; ++i) {
      const Frame frame = Frame::FromNormal(SampleUniformSphere(random_.NextPair()));
      const Vec2 disk = SampleDisk(random_.NextPair());
      const Vec3 beside = frame.x * disk.x + frame.y * disk.y + frame.z;
      Ray ray(box.Center() + beside * static_cast<float>(radius), -frame.z);
      for (HitRecord hit; scene.Intersect(ray, &hit); hit = HitRecord()) {
        const SurfacePoint point = scene.SurfaceAt(ray, hit);
        by_lines[EighthOf(box, point.p)] += 2 * kPi * radius * radius / kCount;
        ray = SpawnRay(point, ray.direction);
      }
      const AreaSample sample = sampler.SampleArea(random_.NextPair());
      ASSERT_GT(sample.pdf, 0.0f);
      ASSERT_EQ(sampler.PdfArea(sample.point.n_geometric), sample.pdf);
      const double area = 1 / (static_cast<double>(sample.pdf) * kCount);
      by_points[EighthOf(box, sample.point.p)] += area;
      squares[EighthOf(box, sample.point.p)] += area * area;
    }
    const double total = std::accumulate(by_points, by_points + 8, 0.0);
    EXPECT_NEAR(total / sampler.Area(), 1, 0.012);
    // Flat shapes lie in the middle of their box, where rounding decides.
    const bool is_flat = sampler.FlatNormal() != Vec3();
    if (is_flat) return;
    for (int eighth = 0; eighth < 8; ++eighth) {
      // A line that crosses a part twice counts as two that do not depend on each other.
      const double of_one = 2 * kPi * radius * radius / kCount;
      const double variance = 2 * by_lines[eighth] * of_one + squares[eighth];
      EXPECT_LT(std::abs(by_lines[eighth] - by_points[eighth]),
                test::kLargestDeviate * std::sqrt(variance))
          << eighth;
    }
  });
}

// A drawn point lies on the surface, within its error, and a ray that leaves it does not meet it
// again at once.
TEST_P(EverySampledShape, PointsLieOnTheSurface) {
  ForPlacements([this](const Scene& scene, const SurfaceSampler& sampler, const Bounds3& box) {
    const float size = Length(box.Extent());
    int met = 0;
    for (int i = 0; i < 5000; ++i) {
      const AreaSample sample = sampler.SampleArea(random_.NextPair());
      const Vec3 n = sample.point.n_geometric;
      ASSERT_NEAR(Length(n), 1, 1e-6);
      // From a little above straight down onto it.
      const Ray ray(sample.point.p + n * (0.01f * size), -n);
      HitRecord hit;
      if (!scene.Intersect(ray, &hit)) continue;  // At the very rim.
      const SurfacePoint found = scene.SurfaceAt(ray, hit);
      if (hit.t < 0.0099f * size) continue;  // Something of it lies above.
      ++met;
      ASSERT_LT(Length(found.p - sample.point.p), 2 * Length(sample.point.p_error) + 1e-5f * size);
      ASSERT_GT(Dot(found.n_geometric, n), 0.99f) << "the normal is not on the side of the surface";
      for (const Vec3 w : {n, -n}) {
        HitRecord again;
        const Ray leaving = SpawnRay(sample.point, w);
        if (!scene.Intersect(leaving, &again)) continue;
        const Vec3 other = scene.SurfaceAt(leaving, again).n_geometric;
        if (std::abs(Dot(other, n)) < 0.99f) continue;  // Another face, at an edge.
        ASSERT_GT(again.t, 1e-4f * size);
      }
    }
    EXPECT_GT(met, 4000);
  });
}

// Scaled by 2, a surface has four times the area.
TEST_P(EverySampledShape, AreaGrowsWithTheSquareOfItsSize) {
  const auto plain = SceneOfShape(GetParam().example);
  const auto doubled = SceneOfShape(GetParam().example, "x_rotate 20", "scale 2 2 2");
  EXPECT_NEAR(SamplerOf(*doubled)->Area() / SamplerOf(*plain)->Area(), 4, 1e-5);
}

// Cubes of lengths would leave the range of floats here.
TEST_P(EverySampledShape, IsDrawnAlikeAtEveryScale) {
  const auto usual_scene = SceneOfShape(GetParam().example);
  const auto usual = SamplerOf(*usual_scene);
  for (const auto& [text, scale] :
       {std::pair("scale 1.1368683772161603e-13 1.1368683772161603e-13 "
                  "1.1368683772161603e-13",
                  0x1p-43f),
        std::pair("scale 8796093022208 8796093022208 8796093022208", 0x1p43f)}) {
    const auto scene = SceneOfShape(GetParam().example, "", text);
    const auto sampler = SamplerOf(*scene);
    int drawn = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 from = PointAround(usual_scene->Bounds());
      const Vec2 u = random_.NextPair();
      const SurfaceSample expected = usual->Sample(from, u);
      const SurfaceSample sample = sampler->Sample(from * scale, u);
      ASSERT_EQ(sample.pdf > 0, expected.pdf > 0);
      if (expected.pdf == 0) continue;
      ++drawn;
      ASSERT_NEAR(sample.pdf / expected.pdf, 1, 1e-3);
      const Vec3 p = from + expected.direction * expected.distance;
      ASSERT_NEAR(sampler->Pdf(from * scale, p * scale, sample.n) / usual->Pdf(from, p, expected.n),
                  1, 1e-3);
    }
    EXPECT_GT(drawn, 100);
  }
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
