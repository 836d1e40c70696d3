#include "geometry/triangle.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "geometry/bounds3.h"
#include "geometry/spawn_ray.h"
#include "math/elementary.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;
using Corners = std::array<Vec3, 3>;

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr Corners kRightAngle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

bool Intersect(const Corners& triangle, const Ray& ray, HitRecord* hit) {
  return IntersectTriangle(ShearedRay(ray), ray.t_min, triangle[0], triangle[1], triangle[2], hit);
}

bool IsHit(const Corners& triangle, const Ray& ray) {
  HitRecord hit;
  return Intersect(triangle, ray, &hit);
}

Vec3 RandomPoint(UniformNumbers* random) {
  const Vec2 xy = random->NextPair();
  return {2 * xy.x - 1, 2 * xy.y - 1, 2 * random->Next() - 1};
}

TEST(IntersectTriangle, StoresDistanceAndBarycentricWeights) {
  HitRecord hit;
  ASSERT_TRUE(Intersect(kRightAngle, Ray({0.25f, 0.5f, 4}, {0, 0, -2}), &hit));
  EXPECT_EQ(hit.t, 2.0f);
  EXPECT_EQ(hit.u, 0.25f);
  EXPECT_EQ(hit.v, 0.5f);
}

TEST(IntersectTriangle, IsHitFromBothSides) {
  EXPECT_TRUE(IsHit(kRightAngle, Ray({0.25f, 0.25f, 1}, {0, 0, -1})));
  EXPECT_TRUE(IsHit(kRightAngle, Ray({0.25f, 0.25f, -1}, {0, 0, 1})));
}

TEST(IntersectTriangle, EdgesAndCornersBelongToIt) {
  for (const Vec3 p : {Vec3{0.5f, 0, 1}, Vec3{0, 0.5f, 1}, Vec3{0.5f, 0.5f, 1}, Vec3{0, 0, 1},
                       Vec3{1, 0, 1}, Vec3{0, 1, 1}}) {
    EXPECT_TRUE(IsHit(kRightAngle, Ray(p, {0, 0, -1}))) << p.x << " " << p.y;
  }
}

TEST(IntersectTriangle, OneStepBeyondAnEdgeMisses) {
  EXPECT_FALSE(IsHit(kRightAngle, Ray({0.5f, -1e-45f, 1}, {0, 0, -1})));
  EXPECT_FALSE(IsHit(kRightAngle, Ray({std::nextafter(0.5f, 1.0f), 0.5f, 1}, {0, 0, -1})));
}

TEST(IntersectTriangle, SeenEdgeOnItIsMissed) {
  EXPECT_FALSE(IsHit(kRightAngle, Ray({-1, 0.25f, 0}, {1, 0, 0})));
}

// The plane is seen nearly edge-on, and the ray passes by the corner by a rounding error: it meets
// the plane somewhere else, where the triangle is not.
TEST(IntersectTriangle, ACornerIsHitWhereItIsHoweverTheTriangleIsTurned) {
  UniformNumbers random(4);
  int hits = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 origin = RandomPoint(&random) * 3, corner = RandomPoint(&random);
    const Vec3 direction = corner - origin;
    const Corners triangle = {corner, corner + direction * 0.5f + RandomPoint(&random) * 1e-5f,
                              corner + RandomPoint(&random)};
    HitRecord hit;
    if (!Intersect(triangle, Ray(origin, direction), &hit) || hit.u != 0 || hit.v != 0) continue;
    ++hits;
    EXPECT_NEAR(hit.t, 1, 0x1p-23) << i;  // The direction is rounded.
  }
  EXPECT_GT(hits, 10000);
}

TEST(IntersectTriangle, TheLowerLimitCountsAndTheUpperOneDoesNot) {
  Ray ray({0.25f, 0.25f, 2}, {0, 0, -1});
  ray.t_min = 2;
  EXPECT_TRUE(IsHit(kRightAngle, ray));
  ray.t_min = std::nextafter(2.0f, 3.0f);
  EXPECT_FALSE(IsHit(kRightAngle, ray));

  ray.t_min = 0;
  HitRecord hit;
  hit.t = 2;
  EXPECT_FALSE(Intersect(kRightAngle, ray, &hit));
  hit.t = std::nextafter(2.0f, 3.0f);
  EXPECT_TRUE(Intersect(kRightAngle, ray, &hit));
}

TEST(IntersectTriangle, AMissLeavesTheRecordAsItWas) {
  HitRecord hit;
  hit.t = 7, hit.u = 8, hit.v = 9;
  EXPECT_FALSE(Intersect(kRightAngle, Ray({5, 5, 1}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 7.0f);
  EXPECT_EQ(hit.u, 8.0f);
  EXPECT_EQ(hit.v, 9.0f);
}

TEST(IntersectTriangle, RaysThatAreNoRaysMiss) {
  EXPECT_FALSE(IsHit(kRightAngle, Ray({0.25f, 0.25f, 1}, {0, 0, 0})));
  EXPECT_FALSE(IsHit(kRightAngle, Ray({0.25f, 0.25f, 1}, {0, 0, kNaN})));
  EXPECT_FALSE(IsHit(kRightAngle, Ray({kNaN, 0.25f, 1}, {0, 0, -1})));
  EXPECT_FALSE(IsHit(kRightAngle, Ray({kLargest, 0.25f, 1}, {-kLargest, 0, -1})));
}

// Areas go as the square of the size: in single precision they vanish below 1e-22 and overflow
// above 1e19.
TEST(IntersectTriangle, FindsTheSameHitAtAnyScale) {
  for (const float scale : {0x1p-100f, 0x1p-75f, 0x1p-30f, 1.0f, 0x1p30f, 0x1p70f, 0x1p100f}) {
    const Corners triangle = {{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}}};
    HitRecord hit;
    ASSERT_TRUE(Intersect(triangle, Ray({0.25f * scale, 0.5f * scale, scale}, {0, 0, -1}), &hit))
        << scale;
    EXPECT_EQ(hit.t, scale);
    EXPECT_EQ(hit.u, 0.25f);
    EXPECT_EQ(hit.v, 0.5f);
  }
}

// The same decision and distance as a plain test in double, except within rounding of an edge.
TEST(IntersectTriangle, AgreesWithDoublePrecision) {
  UniformNumbers random(1);
  int hits = 0;
  for (int i = 0; i < 300000; ++i) {
    const Corners triangle = {RandomPoint(&random), RandomPoint(&random), RandomPoint(&random)};
    const Vec3 origin = RandomPoint(&random) * 3;
    const Vec3 direction = RandomPoint(&random) * 0.5f - origin;
    const Vec3d a = ToDouble(triangle[0]), o = ToDouble(origin), d = ToDouble(direction);
    const Vec3d e1 = ToDouble(triangle[1]) - a, e2 = ToDouble(triangle[2]) - a;
    const double determinant = Dot(e1, Cross(d, e2));
    const double u = Dot(o - a, Cross(d, e2)) / determinant;
    const double v = Dot(d, Cross(o - a, e1)) / determinant;
    const double t = Dot(e2, Cross(o - a, e1)) / determinant;
    if (std::abs(determinant) < 1e-3) continue;  // Nearly edge-on: nothing is exact.
    const double inside = std::min({u, v, 1 - u - v, t});
    if (std::abs(inside) < 1e-4) continue;
    HitRecord hit;
    ASSERT_EQ(Intersect(triangle, Ray(origin, direction), &hit), inside > 0) << i;
    if (inside < 0) continue;
    ++hits;
    EXPECT_FLOAT_EQ(hit.t, static_cast<float>(t));
    EXPECT_NEAR(hit.u, u, 2e-3);
    EXPECT_NEAR(hit.v, v, 2e-3);
  }
  EXPECT_GT(hits, 10000);
}

TEST(TriangleNormal, PointsToWhereTheCornersAreCounterClockwise) {
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {0, 3, 0}, {2, 0, 0}), (Vec3{0, 0, -1}));
}

TEST(TriangleNormal, IsAUnitVectorAtAnyScaleAndZeroWithoutArea) {
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {1e-40f, 0, 0}, {0, 1e-40f, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {1e38f, 0, 0}, {0, 1e38f, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(TriangleNormal({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), (Vec3{0, 0, 0}));
}

// Whichever way it goes from there, also where the triangle lies in a plane of the axes.
TEST(SpawnRay, FromATriangleDoesNotHitItAgain) {
  UniformNumbers random(3);
  for (const float far : {0.0f, 1.0f, 1000.0f}) {
    for (const bool is_level : {false, true}) {
      int hits = 0;
      for (int i = 0; i < 100000; ++i) {
        Corners corners;
        for (Vec3& corner : corners) {
          corner = RandomPoint(&random) + Vec3{far, far, far};
          if (is_level) corner.z = far;
        }
        const auto& [a, b, c] = corners;
        Vec2 uv = random.NextPair();
        if (uv.x + uv.y > 1) uv = Vec2{1, 1} - uv;
        const Vec3 n = TriangleNormal(a, b, c);
        const SurfacePoint point{TrianglePoint(a, b, c, uv.x, uv.y),
                                 TrianglePointError(a, b, c, uv.x, uv.y), n, n};
        hits += IsHit(corners, SpawnRay(point, Normalize(RandomPoint(&random))));
      }
      EXPECT_EQ(hits, 0) << far << (is_level ? " level" : "");
    }
  }
}

/// A closed surface: rays from inside cannot leave it anywhere.
struct ClosedMesh {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;

  bool IsHitBy(const Ray& ray) const {
    const ShearedRay sheared(ray);
    HitRecord hit;
    for (const auto& [a, b, c] : triangles) {
      if (IntersectTriangle(sheared, 0, positions[a], positions[b], positions[c], &hit))
        return true;
    }
    return false;
  }
};

/// Rings of points around the y axis between two poles, as a globe is drawn.
ClosedMesh Globe(std::string name, uint32_t rings, uint32_t sectors, Vec3 scale, Vec3 center) {
  ClosedMesh globe{std::move(name), {}, {}};
  globe.positions.push_back(center + Vec3{0, scale.y, 0});
  for (uint32_t i = 1; i <= rings; ++i) {
    const double height = kPi * i / (rings + 1);
    for (uint32_t j = 0; j < sectors; ++j) {
      const double turn = 2 * kPi * j / sectors;
      const Vec3d p{Sin(height) * Cos(turn), Cos(height), Sin(height) * Sin(turn)};
      globe.positions.push_back(center + ToFloat(p) * scale);
    }
  }
  globe.positions.push_back(center - Vec3{0, scale.y, 0});
  const uint32_t last = rings * sectors + 1;
  for (uint32_t j = 0; j < sectors; ++j) {
    const uint32_t k = (j + 1) % sectors;
    globe.triangles.push_back({0, 1 + j, 1 + k});
    for (uint32_t i = 0; i + 1 < rings; ++i) {
      const uint32_t upper = 1 + i * sectors, lower = upper + sectors;
      globe.triangles.push_back({upper + j, lower + j, lower + k});
      globe.triangles.push_back({upper + j, lower + k, upper + k});
    }
    globe.triangles.push_back({last, last - sectors + k, last - sectors + j});
  }
  return globe;
}

// A ray from inside towards any point of an edge, or any corner, hits something: 1e6 rays in all.
TEST(IntersectTriangle, ClosedMeshesAreWatertight) {
  const ClosedMesh meshes[] = {
      Globe("sphere", 5, 8, {1, 1, 1}, {0, 0, 0}),
      Globe("octahedron", 1, 4, {1, 1, 1}, {0, 0, 0}),
      Globe("far from the origin", 3, 6, {1, 1, 1}, {1000, -300, 77}),
      Globe("slivers", 3, 8, {1000, 1, 0.01f}, {0, 0, 0}),
      Globe("tiny", 3, 6, {1e-20f, 1e-20f, 1e-20f}, {0, 0, 0}),
  };
  UniformNumbers random(2);
  for (const ClosedMesh& mesh : meshes) {
    Bounds3 bounds;
    for (const Vec3 p : mesh.positions) bounds.Extend(p);
    int escaped = 0;
    for (int i = 0; i < 200000; ++i) {
      const auto pick = [&](size_t count) {
        return static_cast<size_t>(random.Next() * static_cast<float>(count));
      };
      const auto& triangle = mesh.triangles[pick(mesh.triangles.size())];
      const size_t corner = pick(3);
      const Vec3 p = mesh.positions[triangle[corner]];
      const Vec3 q = mesh.positions[triangle[(corner + 1) % 3]];
      const Vec3 origin = bounds.Center() + RandomPoint(&random) * bounds.Extent() * 0.05f;
      const bool at_corner = i % 4 == 0;
      const Vec3 target = at_corner ? p : p + (q - p) * random.Next();
      if (!mesh.IsHitBy(Ray(origin, target - origin))) ++escaped;
    }
    EXPECT_EQ(escaped, 0) << mesh.name;
  }
}

}  // namespace
}  // namespace candela
