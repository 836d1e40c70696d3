// What a view camera can do: shift the picture's window, tilt the plane of focus, turn the blades.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cameras/perspective_camera.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

/// Looks along -z from the origin, with a lens of radius 0.1 focused at 5.
CameraSpec View() {
  CameraSpec spec{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90};
  spec.aperture = 0.2f;
  spec.focus_distance = 5;
  return spec;
}

// The window is another part of the same image plane: upright lines stay upright.
TEST(ViewCamera, ShiftMovesTheWindow) {
  const PerspectiveCamera plain(View());
  CameraSpec spec = View();
  spec.shift = {0.5f, -1.25f};
  const PerspectiveCamera shifted(spec);
  const Vec2 u{0.25f, 0.75f};
  for (const Vec2 p : {Vec2{0, 0}, Vec2{-0.5f, 1.25f}, Vec2{1, 0.75f}}) {
    const Vec2 moved = p + spec.shift;
    EXPECT_LT(Length(shifted.GenerateRay(p).direction - plain.GenerateRay(moved).direction), 2e-7f);
    const Ray a = shifted.GenerateRay(p, u), b = plain.GenerateRay(moved, u);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_LT(Length(a.direction - b.direction), 3e-7f);
  }
  EXPECT_EQ(shifted.DepthOf({3, 4, -7}), 7);
  EXPECT_EQ(shifted.FootprintPerUnit().spread, plain.FootprintPerUnit().spread);
}

TEST(ViewCamera, WithoutShiftAndTiltIsTheSameToTheBit) {
  const PerspectiveCamera plain(View());
  CameraSpec spec = View();
  spec.shift = spec.tilt = {0, -0.0f};
  const PerspectiveCamera other(spec);
  UniformNumbers random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p = random.NextPair(), u = random.NextPair();
    EXPECT_EQ(plain.GenerateRay(p, u).direction, other.GenerateRay(p, u).direction);
  }
}

// The plane at the depth 5 + x tan 30 + y tan -50 is sharp: all rays of an image point meet there.
TEST(ViewCamera, TiltLeansThePlaneOfFocus) {
  CameraSpec spec = View();
  spec.tilt = {30, -50};
  const PerspectiveCamera camera(spec);
  const double slope_x = std::tan(M_PI / 6), slope_y = std::tan(-50 * M_PI / 180);
  UniformNumbers random(2);
  int before = 0, behind = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p{2 * random.Next() - 1, 2 * random.Next() - 1};
    const Ray middle = camera.GenerateRay(p);
    // The depth z of the ray (x, y, -1) z solves z = 5 + z (x tan 30 + y tan -50).
    const double z =
        5 / (1 - static_cast<double>(p.x) * slope_x - static_cast<double>(p.y) * slope_y);
    if (std::abs(z) > 100) continue;
    const Ray ray = camera.GenerateRay(p, random.NextPair());
    ASSERT_LT(ray.direction.z, 0) << "rays go ahead even where they come from a point behind";
    ASSERT_GT(Dot(ray.direction, middle.direction), 0.95f);
    const double t =
        (-z - static_cast<double>(ray.origin.z)) / static_cast<double>(ray.direction.z);
    const Vec3d met = ToDouble(ray.origin) + ToDouble(ray.direction) * t;
    const double tolerance = 2e-6 * std::abs(z) + 1e-6;
    ASSERT_NEAR(met.x, static_cast<double>(p.x) * z, tolerance);
    ASSERT_NEAR(met.y, static_cast<double>(p.y) * z, tolerance);
    ++(z > 0 ? before : behind);
  }
  EXPECT_GT(before, 1000);
  EXPECT_GT(behind, 100);
}

// Where the plane of focus is met at infinity the lens sees one direction from everywhere.
TEST(ViewCamera, TiltedToInfinitySeesParallelRays) {
  CameraSpec spec = View();
  spec.tilt = {0, 45};
  const PerspectiveCamera camera(spec);
  UniformNumbers random(3);
  for (int i = 0; i < 100; ++i) {
    const Ray ray = camera.GenerateRay({0, 1}, random.NextPair());
    EXPECT_LT(Length(ray.direction - camera.GenerateRay({0, 1}).direction), 2e-7f);
  }
}

// Three blades with a corner on top, turned to the left by a quarter of a turn.
TEST(ViewCamera, BladesAreTurnedCounterClockwise) {
  for (const float rotation : {0.0f, 90.0f, 30.0f}) {
    CameraSpec spec = View();
    spec.blades = 3;
    spec.blade_rotation = rotation;
    const PerspectiveCamera camera(spec);
    const double degrees = (90 + static_cast<double>(rotation)) * M_PI / 180;
    UniformNumbers random(4);
    double to_corner = 0, away = 0;
    for (int i = 0; i < 100000; ++i) {
      const Vec3 p = camera.GenerateRay({0, 0}, random.NextPair()).origin;
      const double along = static_cast<double>(p.x) * std::cos(degrees) +
                           static_cast<double>(p.y) * std::sin(degrees);
      to_corner = std::max(to_corner, along);
      away = std::max(away, -along);
    }
    EXPECT_NEAR(to_corner, 0.1, 2e-3);
    EXPECT_NEAR(away, 0.05, 1e-4);
  }
}

}  // namespace
}  // namespace candela
