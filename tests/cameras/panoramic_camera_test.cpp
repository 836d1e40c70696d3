#include "cameras/panoramic_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela {
namespace {

CameraSpec View(float fov_degrees) {
  CameraSpec spec;
  spec.center = {1, 2, 3};
  spec.fov_degrees = fov_degrees;
  return spec;
}

void ExpectDirection(const PanoramicCamera& camera, Vec2 image_point, Vec3 expected) {
  const Vec3 direction = camera.GenerateRay(image_point).direction;
  EXPECT_LT(Length(direction - expected), 2e-7f) << image_point.x << " " << image_point.y;
}

// The directions of a picture twice as wide as it is high, as an environment has them.
TEST(PanoramicCamera, ShowsAllDirections) {
  const PanoramicCamera camera(View(180));
  ExpectDirection(camera, {0, 0}, {0, 0, -1});
  ExpectDirection(camera, {1, 0}, {1, 0, 0});
  ExpectDirection(camera, {-1, 0}, {-1, 0, 0});
  ExpectDirection(camera, {2, 0}, {0, 0, 1});
  ExpectDirection(camera, {-2, 0}, {0, 0, 1});
  ExpectDirection(camera, {0.3f, 1}, {0, 1, 0});
  ExpectDirection(camera, {-1.3f, -1}, {0, -1, 0});
  const float half = std::sqrt(0.5f);
  ExpectDirection(camera, {1, 0.5f}, {half, half, 0});
  ExpectDirection(camera, {-0.5f, 0}, {-half, 0, -half});
}

// One unit is half the field of view, in both directions.
TEST(PanoramicCamera, MapsAnglesEvenly) {
  const PanoramicCamera camera(View(60));
  for (const double x : {-3.0, 0.0, 0.5}) {
    for (const double y : {-1.0, 0.25, 1.0}) {
      const double longitude = x * M_PI / 6, latitude = y * M_PI / 6;
      ExpectDirection(camera, {static_cast<float>(x), static_cast<float>(y)},
                      {static_cast<float>(std::sin(longitude) * std::cos(latitude)),
                       static_cast<float>(std::sin(latitude)),
                       static_cast<float>(-std::cos(longitude) * std::cos(latitude))});
    }
  }
}

TEST(PanoramicCamera, GoesOnAroundBeyondItsEdges) {
  const PanoramicCamera camera(View(180));
  ExpectDirection(camera, {2.5f, 0}, camera.GenerateRay({-1.5f, 0}).direction);
  ExpectDirection(camera, {0.5f, 1.25f}, camera.GenerateRay({-1.5f, 0.75f}).direction);
  ExpectDirection(camera, {0.5f, -1.25f}, camera.GenerateRay({-1.5f, -0.75f}).direction);
  EXPECT_EQ(camera.GenerateRay({6.001f, 0}).direction, Vec3());
  EXPECT_EQ(camera.GenerateRay({0, 2.001f}).direction, Vec3());
}

// At a latitude t a part of the picture covers cos t of the solid angle.
TEST(PanoramicCamera, SeesTheMoreOfTheSphereTheNearerToTheHorizon) {
  const PanoramicCamera camera(View(180));
  const double at_horizon = 4 / (M_PI * M_PI);
  EXPECT_NEAR(camera.Connect({1, 2, 2}, {})->importance, at_horizon, 1e-6);
  EXPECT_NEAR(camera.Connect({1, 2 + std::sqrt(0.75f), 2.5f}, {})->importance, 2 * at_horizon,
              2e-6);
  EXPECT_FALSE(camera.Connect({1, 5, 3}, {})) << "a pole is no point of the picture";
}

}  // namespace
}  // namespace candela
