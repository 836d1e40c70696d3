#include "geometry/spawn_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela {
namespace {

TEST(NextFloat, IsTheNeighbourOnEitherSide) {
  for (const float x : {0.0f, -0.0f, 1.0f, -1.0f, 0x1p-149f, -0x1p-149f, 3.14159f, -1e30f,
                        0x1p-126f, std::numeric_limits<float>::max()}) {
    EXPECT_EQ(NextFloat(x, 1), std::nextafter(x, INFINITY)) << x;
    EXPECT_EQ(NextFloat(x, -0.5f), std::nextafter(x, -INFINITY)) << x;
    EXPECT_EQ(NextFloat(x, 0.0f), x);
    EXPECT_EQ(NextFloat(x, -0.0f), x);
  }
}

TEST(SpawnRay, StartsOnTheSideItGoesTo) {
  SurfacePoint point;
  point.p = {3, 5, 7};
  point.p_error = {1e-5f, 1e-5f, 1e-5f};
  point.n_geometric = {0, 1, 0};
  EXPECT_GT(SpawnRay(point, {0.6f, 0.8f, 0}).origin.y, 5);
  EXPECT_LT(SpawnRay(point, {0.6f, -0.8f, 0}).origin.y, 5);
  EXPECT_EQ(SpawnRay(point, {0.6f, 0.8f, 0}).origin.x, 3);
}

}  // namespace
}  // namespace candela
