#include "shapes/plane.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// normal 0 2 0 with offset -2 is y = -1: the normal is used as it is written.
TEST(PlaneIntersect, OffsetCountsInUnitsOfTheNormal) {
  HitRecord hit;
  ASSERT_TRUE(Plane({0, 2, 0}, -2).Intersect(Ray({0, 3, 0}, {0, -1, 0}), &hit));
  EXPECT_EQ(hit.t, 4.0f);
}

TEST(PlaneIntersect, IsHitFromBothSides) {
  HitRecord hit;
  ASSERT_TRUE(Plane({0, 1, 0}, -1).Intersect(Ray({0, -3, 0}, {0, 1, 0}), &hit));
  EXPECT_EQ(hit.t, 2.0f);
}

TEST(PlaneIntersect, ParallelRaysMissEvenInside) {
  HitRecord hit;
  EXPECT_FALSE(Plane({0, 1, 0}, -1).Intersect(Ray({0, 0, 0}, {1, 0, 0}), &hit));
  EXPECT_FALSE(Plane({0, 1, 0}, -1).Intersect(Ray({0, -1, 0}, {1, 0, 0}), &hit));
}

TEST(PlaneIntersect, ARayThatStartsOnItHitsAtZero) {
  HitRecord hit;
  ASSERT_TRUE(Plane({0, 1, 0}, -1).Intersect(Ray({5, -1, 5}, {0, -1, 0}), &hit));
  EXPECT_EQ(hit.t, 0.0f);
}

TEST(PlaneIntersect, ThePlaneBehindTheRayIsMissed) {
  HitRecord hit;
  EXPECT_FALSE(Plane({0, 1, 0}, -1).Intersect(Ray({0, 0, 0}, {0, 1, 0}), &hit));
}

TEST(PlaneIntersect, RaysThatAreNoRaysMiss) {
  HitRecord hit;
  EXPECT_FALSE(Plane({0, 1, 0}, -1).Intersect(Ray({0, 0, 0}, {0, 0, 0}), &hit));
  EXPECT_FALSE(Plane({0, 1, 0}, -1).Intersect(Ray({0, kNaN, 0}, {0, -1, 0}), &hit));
}

// The square of such a normal is 0 or infinite in single precision.
TEST(PlaneSurface, TheLengthOfTheNormalDoesNotMatter) {
  for (const float length : {0x1p-120f, 0x1p-80f, 3.0f, 0x1p80f, 0x1p120f}) {
    const Plane plane({0, length, 0}, -length);
    const Ray ray({2, 3, 4}, {0, -1, 0});
    HitRecord hit;
    ASSERT_TRUE(plane.Intersect(ray, &hit)) << length;
    EXPECT_EQ(hit.t, 4.0f);
    const SurfacePoint point = plane.SurfaceAt(ray, hit);
    EXPECT_EQ(point.p, (Vec3{2, -1, 4}));
    EXPECT_EQ(NormalizeAnyLength(point.n_geometric), (Vec3{0, 1, 0}));
  }
}

// Far away the ray's own arithmetic is off by more than a metre; the point is moved back.
TEST(PlaneSurface, ThePointLiesOnThePlaneWithinItsErrorBound) {
  const Plane plane({0, 1, 0}, -1);
  const Ray ray({0, 3, 0}, {1, -4e-7f, 0});
  HitRecord hit;
  ASSERT_TRUE(plane.Intersect(ray, &hit));
  const SurfacePoint point = plane.SurfaceAt(ray, hit);
  EXPECT_LE(std::abs(point.p.y + 1), point.p_error.y);
}

}  // namespace
}  // namespace candela
