#include "cameras/perspective_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela {
namespace {

void ExpectNear(Vec3 a, Vec3 b, float tolerance = 2e-7f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

CameraSpec RightAngle() {
  return {{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, 90};
}

TEST(PerspectiveCamera, TheMiddleRayIsTheDirectionOfView) {
  const Ray ray = PerspectiveCamera(RightAngle()).GenerateRay({0, 0});
  EXPECT_EQ(ray.origin, (Vec3{1, 2, 3}));
  EXPECT_EQ(ray.direction, (Vec3{0, 0, -1}));
  EXPECT_EQ(ray.t_min, 0.0f);
}

// tan 45 degrees is 1: the image plane is as far away as it is half high.
TEST(PerspectiveCamera, EdgesOfTheFieldOfViewAreHalfTheAngleAway) {
  const PerspectiveCamera camera(RightAngle());
  const float half = std::sqrt(0.5f);
  ExpectNear(camera.GenerateRay({0, 1}).direction, {0, half, -half});
  ExpectNear(camera.GenerateRay({1, 0}).direction, {half, 0, -half});
  ExpectNear(camera.GenerateRay({-1, 0}).direction, {-half, 0, -half});
}

TEST(PerspectiveCamera, UpIsNotMadeOrthogonal) {
  CameraSpec spec = RightAngle();
  spec.up = {0, 3, -4};
  const Vec3 expected = Normalize(Vec3{0, 0.6f, -1.8f});
  ExpectNear(PerspectiveCamera(spec).GenerateRay({0, 1}).direction, expected);
}

// The course's formula, direction / tan(fov / 2) + x right + y up, to the last bit.
TEST(PerspectiveCamera, RaysAreThoseOfTheCourse) {
  for (const float fov : {30.0f, 45.0f, 60.0f, 100.0f}) {
    const CameraSpec spec{{0, 0, 10}, {0, 0, -1}, {0, 1, 0}, fov};
    const float tangent = static_cast<float>(std::tan(static_cast<double>(fov) / 360 * M_PI));
    const Vec3 forward = Vec3{0, 0, -1} / tangent;
    for (const Vec2 p : {Vec2{-1, 1}, Vec2{0.3f, -0.7f}, Vec2{0.001f, 0.9f}}) {
      EXPECT_EQ(PerspectiveCamera(spec).GenerateRay(p).direction,
                Normalize(forward + Vec3{1, 0, 0} * p.x + Vec3{0, 1, 0} * p.y));
    }
  }
}

TEST(PerspectiveCamera, LengthsOfTheVectorsDoNotMatter) {
  const Ray expected = PerspectiveCamera(RightAngle()).GenerateRay({0.5f, 0.25f});
  for (const float length : {0x1p-120f, 0x1p-70f, 0x1p70f, 0x1p120f}) {
    CameraSpec spec = RightAngle();
    spec.direction *= length;
    spec.up *= 1 / length;
    EXPECT_EQ(PerspectiveCamera(spec).GenerateRay({0.5f, 0.25f}).direction, expected.direction);
  }
}

TEST(PerspectiveCamera, FieldsOfViewMayBeAsNarrowOrWideAsTheyLike) {
  for (const float fov : {1e-44f, 1e-20f, 1e-3f, 179.99998f}) {
    CameraSpec spec = RightAngle();
    spec.fov_degrees = fov;
    const PerspectiveCamera camera(spec);
    EXPECT_EQ(camera.GenerateRay({0, 0}).direction, (Vec3{0, 0, -1})) << fov;
    EXPECT_NEAR(Length(camera.GenerateRay({1, -1}).direction), 1, 2e-7) << fov;
  }
}

}  // namespace
}  // namespace candela
