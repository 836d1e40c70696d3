// Rays that are none miss, in bounded time; and where the ends of a ray's interval lie.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "tests/kernel/random_group.h"
#include "tests/kernel/sphere_set.h"
#include "tests/kernel/trace_lists.h"

namespace candela::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kTiniest = std::numeric_limits<float>::denorm_min();

/// One of everything, around the origin.
GroupDescription OneOfEverything() {
  UniformNumbers random(5);
  GroupDescription inner = OfMesh(Globe(8, 12));
  GroupDescription group;
  group.Add(Globe(8, 12));
  group.Add(InMotion(Globe(8, 12), 3, 0.1f, &random));
  group.items.push_back({std::make_shared<SphereSet>(std::vector<SphereSet::Sphere>{
                             {{{0, 0, 0}}, 1}, {{{0.5f, 0, 0}}, 0.5f}}),
                         kAnyRay, nullptr});
  const auto shared = std::make_shared<GroupDescription>(inner);
  group.items.push_back(
      {GroupDescription::Instance{shared, {Mat4::Scale({0.5, -0.5, 0.7})}}, kAnyRay, nullptr});
  group.items.push_back({GroupDescription::Instance{
                             shared, {Mat4::Translate({0.1, 0, 0}), Mat4::Translate({-0.1, 0, 0})}},
                         kAnyRay, nullptr});
  return group;
}

/// How many of the rays hit, the same on all ways through the kernel.
size_t CountHits(const GroupDescription& description, const std::vector<Ray>& rays) {
  size_t first_count = 0;
  bool is_first = true;
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    for (const Entry entry : kEntries) {
      const auto hits = IntersectList(*group, entry, rays);
      const auto occluded = OccludedList(*group, entry, rays);
      size_t count = 0;
      for (size_t i = 0; i < rays.size(); ++i) {
        count += hits[i].IsHit();
        EXPECT_EQ(occluded[i], static_cast<uint8_t>(hits[i].IsHit()))
            << ToString(options) << ", " << ToString(entry) << ": " << ToString(rays[i]);
        if (!hits[i].IsHit()) continue;
        EXPECT_TRUE(std::isfinite(hits[i].t) && hits[i].t >= rays[i].t_min) << ToString(rays[i]);
      }
      if (is_first) first_count = count;
      is_first = false;
      EXPECT_EQ(count, first_count) << ToString(options) << ", " << ToString(entry);
    }
  }
  return first_count;
}

TEST(OddRays, OrdinaryOnesOfTheseTestsHit) {
  EXPECT_EQ(CountHits(OneOfEverything(), {Ray({0, 0, 0}, {0.3f, 0.4f, 0.5f}),
                                          Ray({0, 0, -3}, {0, 0, 1}), Ray({0, 3, 0}, {0, -1, 0})}),
            3u);
}

TEST(OddRays, WithANumberMissingMiss) {
  std::vector<Ray> rays;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Vec3 direction : {Vec3{1, 2, 3}, Vec3{0, 0, 1}}) {
      rays.emplace_back(Vec3{0, 0, 0}, direction);
      rays.back().origin[axis] = kNaN;
      rays.emplace_back(Vec3{0, 0, 0}, direction);
      rays.back().direction[axis] = kNaN;
    }
  }
  rays.emplace_back(Vec3{0, 0, 0}, Vec3{1, 2, 3});
  rays.back().t_min = kNaN;
  rays.emplace_back(Vec3{0, 0, 0}, Vec3{1, 2, 3});
  rays.back().t_max = kNaN;
  EXPECT_EQ(CountHits(OneOfEverything(), rays), 0u);
}

TEST(OddRays, FromInfinityOrWithAnInfiniteOrVanishingDirectionMiss) {
  std::vector<Ray> rays;
  for (const float bad : {kInfinity, -kInfinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      rays.emplace_back(Vec3{0, 0, 0}, Vec3{1, 2, 3});
      rays.back().origin[axis] = bad;
      rays.emplace_back(Vec3{0, 0, 0}, Vec3{1, 2, 3});
      rays.back().direction[axis] = bad;
      rays.emplace_back(Vec3{0, 0, 0}, Vec3{0, 0, 0});
      rays.back().direction[axis] = bad;
    }
  }
  for (const float zero : {0.0f, -0.0f, kTiniest, -1e-30f}) {
    rays.emplace_back(Vec3{0, 0, 0}, Vec3{zero, zero, zero});
  }
  for (const float large : {1e20f, kLargest}) {
    rays.emplace_back(Vec3{0, 0, 0}, Vec3{large, 0, 0});
    rays.emplace_back(Vec3{0, 0, 0}, Vec3{large, -large, large});
  }
  EXPECT_EQ(CountHits(OneOfEverything(), rays), 0u);
}

TEST(OddRays, BetweenLimitsThatHoldNothingMiss) {
  std::vector<Ray> rays;
  const auto add = [&](float t_min, float t_max) {
    rays.emplace_back(Vec3{0, 0, -3}, Vec3{0.01f, 0.02f, 1});
    rays.back().t_min = t_min;
    rays.back().t_max = t_max;
  };
  add(3, 2);
  add(kInfinity, kInfinity);
  add(kInfinity, 0);
  add(kLargest, kLargest);
  add(10, kInfinity);
  add(0, 0);
  add(0, -0.0f);
  add(0, -1);
  add(0, -kInfinity);
  add(0, kTiniest);
  add(-1, kLargest);  // t_min may not be negative.
  add(-kInfinity, kLargest);
  EXPECT_EQ(CountHits(OneOfEverything(), rays), 0u);
}

TEST(OddRays, WithoutAnEndOrFromMinusZeroHit) {
  std::vector<Ray> rays;
  for (const float t_min : {0.0f, -0.0f}) {
    rays.emplace_back(Vec3{-0.0f, 0, -3}, Vec3{0, -0.0f, 1});
    rays.back().t_min = t_min;
    rays.back().t_max = kInfinity;
    rays.emplace_back(Vec3{0, -3, -0.0f}, Vec3{-0.0f, 1, 0});
    rays.back().t_min = t_min;
  }
  EXPECT_EQ(CountHits(OneOfEverything(), rays), rays.size());
}

// Times are clamped to the shutter interval; one that is not a number is its beginning.
TEST(OddRays, AtOddTimesAreAtTheEndsOfTheShutter) {
  UniformNumbers random(6);
  const GroupDescription description =
      OfMesh(InMotion(Soup(200, 0.1f, 0.5f, &random), 3, 0.5f, &random));
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    for (const auto& [odd, plain] : {std::pair{kNaN, 0.0f},
                                     {-0.0f, 0.0f},
                                     {-3.0f, 0.0f},
                                     {-kInfinity, 0.0f},
                                     {1.5f, 1.0f},
                                     {kInfinity, 1.0f},
                                     {kTiniest, kTiniest}}) {
      std::vector<Ray> rays = RandomRays(description, 200, &random), plain_rays = rays;
      for (Ray& ray : rays) ray.time = odd;
      for (Ray& ray : plain_rays) ray.time = plain;
      const auto right = IntersectList(*group, Entry::kOneByOne, plain_rays);
      for (const Entry entry : kEntries) {
        const auto hits = IntersectList(*group, entry, rays);
        for (size_t i = 0; i < rays.size(); ++i) {
          ASSERT_TRUE(IsSame(hits[i], right[i])) << ToString(rays[i]);
        }
      }
    }
  }
}

// A square across the ray at 2, and a sphere that it enters at 2.
TEST(RayLimits, TheLowerOneCountsAndTheUpperOneDoesNot) {
  GroupDescription sphere;
  sphere.items.push_back(
      {std::make_shared<SphereSet>(std::vector<SphereSet::Sphere>{{{{0, -3, 0}}, 1}}), kAnyRay,
       nullptr});
  GroupDescription instance;
  instance.items.push_back(
      {GroupDescription::Instance{std::make_shared<GroupDescription>(OfMesh(CurvedGrid(3, 0))),
                                  {Mat4::Translate({0, -2, 0})}},
       kAnyRay, nullptr});
  for (const GroupDescription& description :
       {OfMesh(Moved(CurvedGrid(3, 0), 1, {0, -2, 0})), instance, sphere}) {
    const float next = std::nextafter(2.0f, 3.0f);
    const bool is_sphere = description.items[0].content.index() == 2;
    std::vector<Ray> rays(6, Ray({0, 0, 0}, {0, -1, 0}));
    rays[0].t_min = 2;                        // Hit.
    rays[1].t_max = next;                     // Hit.
    rays[2].t_min = 2, rays[2].t_max = next;  // Hit.
    rays[3].t_max = 2;                        // Miss.
    rays[4].t_min = 2, rays[4].t_max = 2;     // Miss.
    rays[5].t_min = next;                     // Miss; of a sphere, its other side.
    for (const BuildOptions& options : AllBuildOptions()) {
      const auto group = MustBuild(description, options);
      for (const Entry entry : kEntries) {
        const auto hits = IntersectList(*group, entry, rays);
        for (size_t i = 0; i < rays.size(); ++i) {
          const bool is_hit = i < 3 || (i == 5 && is_sphere);
          EXPECT_EQ(hits[i].IsHit(), is_hit) << i << " " << ToString(options);
          if (i < 3) {
            EXPECT_EQ(hits[i].t, 2.0f);
          }
        }
      }
    }
  }
}

TEST(RayLimits, AMissLeavesTheRecordAsItWas) {
  const GroupDescription description = OneOfEverything();
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    HitRecord before;
    before.t = 0.25f, before.u = 7, before.v = 8, before.object = 9, before.primitive = 10;
    before.nested[0] = 11;
    const std::vector<Ray> rays(20, Ray({0, 0, -3}, {0, 0, 1}));
    HitRecord hit = before;
    EXPECT_FALSE(group->Intersect(rays[0], &hit));
    EXPECT_TRUE(IsSame(hit, before));
    for (const RayOrder order : {RayOrder::kScattered, RayOrder::kCoherent}) {
      std::vector<HitRecord> hits(rays.size(), before);
      group->Intersect(order, rays, hits);
      for (const HitRecord& each : hits) EXPECT_TRUE(IsSame(each, before)) << ToString(options);
    }
  }
}

// In the planes of boxes: 0 * infinity lies near. Each vertex, and points in between, of a lattice.
TEST(RaysAlongAxes, MeetFlatGridsAtEdgesAndVertices) {
  GroupDescription description;
  for (int i = 0; i < 3; ++i) {
    description.Add(Moved(CurvedGrid(8, 0), 1, {0, static_cast<float>(i) - 1, 0}));
  }
  std::vector<Ray> rays;
  std::vector<float> distance;
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j <= 16; ++j) {
      const float x = static_cast<float>(i) / 8 - 1, z = static_cast<float>(j) / 8 - 1;
      for (const float zero : {0.0f, -0.0f}) {
        rays.emplace_back(Vec3{x, 4, z}, Vec3{zero, -1, -zero});
        distance.push_back(3);
        rays.emplace_back(Vec3{x, -4, z}, Vec3{zero, 1, zero});
        distance.push_back(3);
        rays.emplace_back(Vec3{x, 1, z}, Vec3{zero, 1, zero});
        distance.push_back(0);
        rays.emplace_back(Vec3{x, 0.5f, z}, Vec3{-zero, 8, zero});
        distance.push_back(0.0625f);
      }
    }
  }
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    for (const Entry entry : kEntries) {
      const auto hits = IntersectList(*group, entry, rays);
      for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_TRUE(hits[i].IsHit()) << ToString(options) << " " << ToString(rays[i]);
        ASSERT_EQ(hits[i].t, distance[i]) << ToString(options) << " " << ToString(rays[i]);
      }
    }
  }
}

// A ray in the plane of a triangle sees it edge-on: it misses, and meets what stands across.
TEST(RaysAlongAxes, InThePlaneOfTrianglesMissThem) {
  GroupDescription description = OfMesh(CurvedGrid(8, 0));
  std::vector<Ray> rays;
  for (int i = 0; i <= 16; ++i) {
    const float x = static_cast<float>(i) / 8 - 1;
    rays.emplace_back(Vec3{x, 0, -4}, Vec3{0, 0, 1});
    rays.emplace_back(Vec3{-4, 0, x}, Vec3{1, 0, 0});
    rays.emplace_back(Vec3{-4, -0.0f, x}, Vec3{1, -0.0f, -0.0f});
    rays.emplace_back(Vec3{x, 0, x}, Vec3{1, 0, 1});
  }
  EXPECT_EQ(CountHits(description, rays), 0u);
  description.Add(BoxMesh({-8, -8, -8}, {8, 8, 8}));
  EXPECT_EQ(CountHits(description, rays), rays.size());
}

}  // namespace
}  // namespace candela::test
