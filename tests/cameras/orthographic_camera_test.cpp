#include "cameras/orthographic_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

/// Looks along -z from (1, 2, 3).
CameraSpec View() {
  CameraSpec spec;
  spec.center = {1, 2, 3};
  return spec;
}

// The picture is as high as it says; its unit is half of that.
TEST(OrthographicCamera, RaysAreParallel) {
  const OrthographicCamera camera(View(), 4);
  for (const Vec2 image_point : {Vec2{0, 0}, Vec2{1, 1}, Vec2{-1.5f, 0.25f}}) {
    const Ray ray = camera.GenerateRay(image_point);
    EXPECT_EQ(ray.direction, (Vec3{0, 0, -1}));
    EXPECT_EQ(ray.origin, (Vec3{1 + 2 * image_point.x, 2 + 2 * image_point.y, 3}));
  }
}

TEST(OrthographicCamera, MakesUpOrthogonal) {
  CameraSpec spec = View();
  spec.up = {0, 3, -4};
  EXPECT_EQ(OrthographicCamera(spec, 4).GenerateRay({0, 1}).origin, (Vec3{1, 4, 3}));
}

TEST(OrthographicCamera, SeesPointsAtAnyDistanceInTheSamePlaceAndSize) {
  const OrthographicCamera camera(View(), 4);
  for (const float distance : {0.25f, 3.0f, 1000.0f}) {
    const auto connection = camera.Connect({2, 1, 3 - distance}, {});
    ASSERT_TRUE(connection);
    EXPECT_EQ(connection->image_point, (Vec2{0.5f, -0.5f}));
    EXPECT_EQ(connection->direction, (Vec3{0, 0, 1}));
    EXPECT_EQ(connection->distance, distance);
    EXPECT_EQ(connection->importance, 0.25f);
  }
}

TEST(OrthographicCamera, SeesNothingBehindItsPlane) {
  const OrthographicCamera camera(View(), 4);
  EXPECT_FALSE(camera.Connect({1, 2, 3.5f}, {}));
  EXPECT_FALSE(camera.Connect({5, 2, 3}, {}));
  EXPECT_FALSE(camera.IsInOnePlace());
}

// P14, CF25: a point seen by parallel rays at the distance D is blurred to a disk of diameter 2 a
// |D - F| / F in the plane of focus, here 0.2 x 5 / 5.
TEST(OrthographicCamera, BlursAPointToADiskOfTheClosedForm) {
  CameraSpec spec = View();
  spec.aperture = 0.2f;
  spec.focus_distance = 5;
  const OrthographicCamera camera(spec, 2);
  EXPECT_FALSE(camera.IsPinhole());
  UniformNumbers numbers(1);
  float widest = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto connection = camera.Connect({1, 2, 3 - 10}, numbers.NextPair());
    ASSERT_TRUE(connection);
    const Vec2 p = connection->image_point;  // Half of the height is 1.
    widest = std::max(widest, 2 * std::sqrt(p.x * p.x + p.y * p.y));
  }
  EXPECT_NEAR(widest, 0.2, 1e-4);
}

TEST(OrthographicCamera, ShowsThePlaneOfFocusSharply) {
  CameraSpec spec = View();
  spec.aperture = 0.5f;
  spec.focus_distance = 5;
  const OrthographicCamera camera(spec, 2);
  UniformNumbers numbers(2);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = camera.GenerateRay({0.5f, -0.25f}, numbers.NextPair());
    const Vec3 p = ray.At((-2 - ray.origin.z) / ray.direction.z);
    ASSERT_NEAR(p.x, 1.5, 2e-6);
    ASSERT_NEAR(p.y, 1.75, 2e-6);
  }
}

}  // namespace
}  // namespace candela
