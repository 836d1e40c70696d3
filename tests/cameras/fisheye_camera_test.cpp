#include "cameras/fisheye_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

CameraSpec View(float fov_degrees) {
  CameraSpec spec;
  spec.center = {1, 2, 3};
  spec.fov_degrees = fov_degrees;
  return spec;
}

/// The angle in degrees between a ray and the direction of view.
double AngleOf(const Ray& ray) {
  return std::acos(-static_cast<double>(ray.direction.z)) * 180 / M_PI;
}

// The angle grows with the radius.
TEST(FisheyeCamera, OfEqualDistancesMapsAngles) {
  for (const float fov : {90.0f, 180.0f, 360.0f}) {
    const FisheyeCamera camera(View(fov), FisheyeMapping::kEquidistant);
    for (const double radius : {0.125, 0.25, 0.5, 0.75}) {
      const auto x = static_cast<float>(0.6 * radius), y = static_cast<float>(-0.8 * radius);
      const Ray ray = camera.GenerateRay({x, y});
      EXPECT_NEAR(AngleOf(ray), radius * static_cast<double>(fov) / 2, 2e-5 * fov);
      EXPECT_NEAR(ray.direction.y / ray.direction.x, -0.8 / 0.6, 1e-5);
    }
  }
}

// The sine of half the angle grows with the radius: sin(t / 2) = r sin(fov / 4).
TEST(FisheyeCamera, OfEqualSolidAnglesMapsHalfAngles) {
  for (const float fov : {90.0f, 180.0f, 360.0f}) {
    const FisheyeCamera camera(View(fov), FisheyeMapping::kEquisolid);
    const double rim = std::sin(static_cast<double>(fov) * M_PI / 720);
    for (const double radius : {0.125, 0.25, 0.5, 0.75}) {
      const Ray ray = camera.GenerateRay({0, static_cast<float>(radius)});
      EXPECT_NEAR(AngleOf(ray), 2 * std::asin(radius * rim) * 180 / M_PI, 2e-5 * fov);
      EXPECT_GT(ray.direction.y, 0);
    }
  }
}

TEST(FisheyeCamera, ShowsTheFieldOfViewInACircle) {
  for (const FisheyeMapping mapping : {FisheyeMapping::kEquidistant, FisheyeMapping::kEquisolid}) {
    const FisheyeCamera camera(View(180), mapping);
    EXPECT_NEAR(AngleOf(camera.GenerateRay({0, 0})), 0, 1e-6);
    EXPECT_NEAR(AngleOf(camera.GenerateRay({1, 0})), 90, 1e-5);
    EXPECT_NEAR(AngleOf(camera.GenerateRay({0, -1})), 90, 1e-5);
    EXPECT_EQ(camera.GenerateRay({0.75f, 0.75f}).direction, Vec3());
    EXPECT_EQ(camera.GenerateRay({0, -1.001f}).direction, Vec3());
    // What is behind is not seen by half of the directions.
    EXPECT_TRUE(camera.Connect({5, 2, 2.9f}, {}));
    EXPECT_FALSE(camera.Connect({5, 2, 3.1f}, {}));
  }
}

// With all directions in the circle, a random one is seen with the same importance everywhere: the
// circle's area over 4 pi, at a distance of 1.
TEST(FisheyeCamera, OfEqualSolidAnglesIsEven) {
  const FisheyeCamera camera(View(360), FisheyeMapping::kEquisolid);
  test::UniformNumbers random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 a = random.NextPair(), b = random.NextPair();
    const Vec3 w = Normalize(Vec3{a.x - 0.5f, a.y - 0.5f, b.x - 0.5f});
    const auto connection = camera.Connect(Vec3{1, 2, 3} + w, {});
    ASSERT_TRUE(connection);
    ASSERT_NEAR(connection->importance, 0.25, 1e-6);
  }
}

TEST(FisheyeCamera, DoesNotKnowWhereOnTheRimItSeesWhatIsRightBehind) {
  for (const FisheyeMapping mapping : {FisheyeMapping::kEquidistant, FisheyeMapping::kEquisolid}) {
    const FisheyeCamera camera(View(360), mapping);
    EXPECT_FALSE(camera.Connect({1, 2, 4}, {}));
    EXPECT_TRUE(camera.Connect({1.01f, 2, 4}, {}));
    EXPECT_EQ(camera.Connect({1, 2, 2}, {})->image_point, (Vec2{0, 0}));
  }
}

}  // namespace
}  // namespace candela
