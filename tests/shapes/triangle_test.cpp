#include "shapes/triangle.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Triangle, HasAFlatNormalWhereItsCornersAreCounterClockwise) {
  const Triangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Ray ray({0.25f, 0.25f, -2}, {0, 0, 1});
  HitRecord hit;
  ASSERT_TRUE(triangle.Intersect(ray, &hit));
  EXPECT_EQ(hit.t, 2.0f);
  const SurfacePoint point = triangle.SurfaceAt(ray, hit);
  EXPECT_EQ(point.p, (Vec3{0.25f, 0.25f, 0}));
  EXPECT_EQ(point.n_geometric, (Vec3{0, 0, 1}));  // Not turned towards the ray.
  EXPECT_EQ(point.n_shading, (Vec3{0, 0, 1}));
}

TEST(Triangle, BoundsAreThoseOfItsCorners) {
  EXPECT_EQ(Triangle({0, 5, 0}, {1, 0, -2}, {0, 1, 0}).ObjectBounds(),
            (Bounds3{{0, 0, -2}, {1, 5, 0}}));
}

TEST(Triangle, OccludesUpToTheEndOfTheRay) {
  const Triangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Ray ray({0.25f, 0.25f, -2}, {0, 0, 1});
  EXPECT_TRUE(triangle.Occludes(ray));
  ray.t_max = 2;
  EXPECT_FALSE(triangle.Occludes(ray));
}

}  // namespace
}  // namespace candela
