#include "shapes/sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// The ray starts inside the sphere: the near root is behind it, the far one is the answer.
TEST(SphereIntersect, RayFromCentreHitsAtOneRadius) {
  HitRecord hit;
  ASSERT_TRUE(Sphere(2).Intersect(Ray({0, 0, 0}, {0, 0, 1}), &hit));
  EXPECT_EQ(hit.t, 2.0f);
}

TEST(SphereIntersect, RayFromOutsideHitsTheNearSide) {
  HitRecord hit;
  ASSERT_TRUE(Sphere(1).Intersect(Ray({0, 0, 5}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 4.0f);
}

TEST(SphereIntersect, DistanceCountsInUnitsOfTheDirection) {
  HitRecord hit;
  ASSERT_TRUE(Sphere(1).Intersect(Ray({0, 0, 5}, {0, 0, -2}), &hit));
  EXPECT_EQ(hit.t, 2.0f);
}

TEST(SphereIntersect, TangentRayHits) {
  HitRecord hit;
  ASSERT_TRUE(Sphere(1).Intersect(Ray({1, 0, 5}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 5.0f);
  EXPECT_FALSE(Sphere(1).Intersect(Ray({std::nextafter(1.0f, 2.0f), 0, 5}, {0, 0, -1}), &hit));
}

TEST(SphereIntersect, TangentRayFromTheSurfaceHitsAtZero) {
  HitRecord hit;
  ASSERT_TRUE(Sphere(1).Intersect(Ray({1, 0, 0}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 0.0f);
}

TEST(SphereIntersect, SphereBehindTheRayIsMissed) {
  HitRecord hit;
  EXPECT_FALSE(Sphere(1).Intersect(Ray({0, 0, 5}, {0, 0, 1}), &hit));
}

TEST(SphereIntersect, TheLowerLimitCounts) {
  Ray ray({0, 0, 5}, {0, 0, -1});
  HitRecord hit;
  ray.t_min = 4;
  ASSERT_TRUE(Sphere(1).Intersect(ray, &hit));
  EXPECT_EQ(hit.t, 4.0f);
}

TEST(SphereIntersect, BeyondTheNearHitTheFarOneIsFound) {
  Ray ray({0, 0, 5}, {0, 0, -1});
  HitRecord hit;
  ray.t_min = std::nextafter(4.0f, 5.0f);
  ASSERT_TRUE(Sphere(1).Intersect(ray, &hit));
  EXPECT_EQ(hit.t, 6.0f);
}

TEST(SphereIntersect, TheUpperLimitDoesNotCount) {
  HitRecord hit;
  hit.t = 4;
  EXPECT_FALSE(Sphere(1).Intersect(Ray({0, 0, 5}, {0, 0, -1}), &hit));
  hit.t = std::nextafter(4.0f, 5.0f);
  EXPECT_TRUE(Sphere(1).Intersect(Ray({0, 0, 5}, {0, 0, -1}), &hit));
}

// The sphere is seen under the angle of a coin at 200 metres; b^2 - c has lost all its digits in
// single precision.
TEST(SphereIntersect, FarAwayTheRimIsStillInItsPlace) {
  const Vec3 origin{0, 0, 10000};
  HitRecord hit;
  EXPECT_TRUE(Sphere(1).Intersect(Ray(origin, Vec3{0.9999f, 0, 0} - origin), &hit));
  hit = {};
  EXPECT_FALSE(Sphere(1).Intersect(Ray(origin, Vec3{1.0001f, 0, 0} - origin), &hit));
  ASSERT_TRUE(Sphere(1).Intersect(Ray(origin, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.t, 9999.0f);
}

TEST(SphereIntersect, SizeDoesNotMatter) {
  for (const float r : {0x1p-140f, 0x1p-100f, 1.0f, 0x1p100f, 0x1p120f}) {
    const Sphere sphere(r);
    const Ray ray({0, 0, 4 * r}, {0, 0, -1});
    HitRecord hit;
    ASSERT_TRUE(sphere.Intersect(ray, &hit)) << r;
    EXPECT_EQ(hit.t, 3 * r);
    const SurfacePoint point = sphere.SurfaceAt(ray, hit);
    EXPECT_EQ(point.p, (Vec3{0, 0, r}));
    EXPECT_EQ(point.n_geometric, (Vec3{0, 0, 1}));
  }
}

TEST(SphereIntersect, RaysThatAreNoRaysMiss) {
  HitRecord hit;
  EXPECT_FALSE(Sphere(1).Intersect(Ray({0, 0, 0}, {0, 0, 0}), &hit));
  EXPECT_FALSE(Sphere(1).Intersect(Ray({0, 0, 5}, {0, kNaN, 0}), &hit));
  EXPECT_FALSE(Sphere(1).Intersect(Ray({kNaN, 0, 5}, {0, 0, -1}), &hit));
}

// Like a globe: the middle of the picture at +z, its right half towards +x, its upper one towards
// +y.
TEST(SphereSurface, IsAGlobeOfTextureCoordinates) {
  const struct {
    Vec3 from;
    Vec2 uv;
  } cases[] = {{{0, 0, 9}, {0.5f, 0.5f}},
               {{9, 0, 0}, {0.75f, 0.5f}},
               {{-9, 0, 0}, {0.25f, 0.5f}},
               {{0, 9, 0}, {0.5f, 1}},
               {{0, -9, 0}, {0.5f, 0}}};
  for (const auto& [from, uv] : cases) {
    HitRecord hit;
    ASSERT_TRUE(Sphere(2).Intersect(Ray(from, -from), &hit));
    SurfacePoint point = Sphere(2).SurfaceAt(Ray(from, -from), hit);
    Sphere(2).AddTextureCoordinates(hit, &point);
    EXPECT_NEAR(point.uv.x, uv.x, 1e-6);
    EXPECT_NEAR(point.uv.y, uv.y, 1e-6);
  }
}

TEST(SphereSurface, TheNormalPointsOutwardsFromInsideToo) {
  const Sphere sphere(2);
  const Ray ray({0, 0, 0}, {3, 0, 0});
  HitRecord hit;
  ASSERT_TRUE(sphere.Intersect(ray, &hit));
  const SurfacePoint point = sphere.SurfaceAt(ray, hit);
  EXPECT_EQ(point.p, (Vec3{2, 0, 0}));
  EXPECT_EQ(point.n_geometric, (Vec3{1, 0, 0}));
  EXPECT_EQ(point.n_shading, (Vec3{1, 0, 0}));
}

}  // namespace
}  // namespace candela
