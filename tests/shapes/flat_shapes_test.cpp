// The flat shapes in z = 0: rectangle and disk.

#include <gtest/gtest.h>

#include <cmath>

#include "shapes/disk.h"
#include "shapes/rectangle.h"

namespace candela {
namespace {

// From three units above, straight down onto the point (x, y) of the plane.
Ray RayDownTo(float x, float y) {
  return Ray({x, y, 3}, {0, 0, -1});
}

TEST(RectangleIntersect, IncludesItsEdgesAndNothingBeyond) {
  const Rectangle rectangle(4, 2);
  HitRecord hit;
  ASSERT_TRUE(rectangle.Intersect(RayDownTo(2, -1), &hit));
  EXPECT_EQ(hit.t, 3);
  hit = {};
  EXPECT_FALSE(rectangle.Intersect(RayDownTo(std::nextafter(2.0f, 3.0f), 0), &hit));
  EXPECT_FALSE(rectangle.Intersect(RayDownTo(0, std::nextafter(1.0f, 2.0f)), &hit));
}

TEST(RectangleIntersect, SeesNothingEdgeOn) {
  HitRecord hit;
  EXPECT_FALSE(Rectangle(2, 2).Intersect(Ray({-3, 0, 0}, {1, 0, 0}), &hit));
}

TEST(RectangleSurface, LiesInItsPlaneAndLooksUp) {
  const Ray ray = RayDownTo(0.5f, 0.25f);
  HitRecord hit;
  ASSERT_TRUE(Rectangle(2, 1).Intersect(ray, &hit));
  const SurfacePoint point = Rectangle(2, 1).SurfaceAt(ray, hit);
  EXPECT_EQ(point.p, (Vec3{0.5f, 0.25f, 0}));
  EXPECT_EQ(point.n_geometric, (Vec3{0, 0, 1}));
}

TEST(DiskIntersect, FindsThePlaneWithinTheRadius) {
  HitRecord hit;
  ASSERT_TRUE(Disk(2).Intersect(RayDownTo(1, -1), &hit));
  EXPECT_EQ(hit.t, 3);
}

TEST(DiskIntersect, IncludesItsEdge) {
  HitRecord hit;
  EXPECT_TRUE(Disk(5).Intersect(RayDownTo(3, 4), &hit));
  EXPECT_FALSE(Disk(5).Intersect(RayDownTo(3, std::nextafter(4.0f, 5.0f)), &hit));
}

TEST(DiskIntersect, SeesNothingEdgeOn) {
  HitRecord hit;
  EXPECT_FALSE(Disk(1).Intersect(Ray({-3, 0, 0}, {1, 0, 0}), &hit));
}

TEST(DiskSurface, LiesInItsPlaneAndLooksUp) {
  const Ray ray = RayDownTo(0.5f, 0.25f);
  HitRecord hit;
  ASSERT_TRUE(Disk(1).Intersect(ray, &hit));
  const SurfacePoint point = Disk(1).SurfaceAt(ray, hit);
  EXPECT_EQ(point.p, (Vec3{0.5f, 0.25f, 0}));
  EXPECT_EQ(point.n_geometric, (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace candela
