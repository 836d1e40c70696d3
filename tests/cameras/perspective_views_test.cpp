// What holds for the perspective camera, however it stands.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "cameras/image_plane.h"
#include "cameras/perspective_camera.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

class EveryView : public testing::TestWithParam<CameraSpec> {
 protected:
  const CameraSpec& spec_ = GetParam();
  const PerspectiveCamera camera_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Perspective, EveryView,
                         testing::Values(CameraSpec{{0, 0, 10}, {0, 0, -1}, {0, 1, 0}, 30},
                                         CameraSpec{{1, 2, 3}, {5, -1, 2}, {0, 1, 0}, 90},
                                         CameraSpec{{-7, 0, 0}, {0, 0, 3}, {0, 2, 1}, 1},
                                         CameraSpec{{0, 1e4f, 0}, {0, -1, 0}, {1, 0, 0}, 170}));

TEST_P(EveryView, TheRayInTheMiddleIsTheDirectionOfView) {
  const Ray ray = camera_.GenerateRay({0, 0});
  EXPECT_EQ(ray.origin, spec_.center);
  EXPECT_NEAR(Dot(ray.direction, NormalizeAnyLength(spec_.direction)), 1, 1e-6);
  EXPECT_EQ(ray.t_min, 0.0f);
}

TEST_P(EveryView, DirectionsAreUnitVectors) {
  for (const Vec2 p : {Vec2{0, 0}, Vec2{1, 1}, Vec2{-1, 0.5f}, Vec2{0.1f, -0.9f}}) {
    EXPECT_NEAR(Length(camera_.GenerateRay(p).direction), 1, 2e-7);
  }
}

// Projected back, the ray of a pixel ends in that pixel: every part of the film is seen, and once.
TEST_P(EveryView, RaysCoverTheFilmOnce) {
  constexpr int kSize = 64;
  const ImagePlane plane(kSize, kSize, PixelGrid::kCentres, false);
  // The edges of the picture are where it says, so the image point of a direction w solves
  // w ~ forward + x right + y up.
  const Vec3d middle = ToDouble(camera_.GenerateRay({0, 0}).direction);
  const Vec3d up = Normalize(ToDouble(spec_.up));
  const Vec3d right = Normalize(Cross(middle, up));
  const double reach = std::tan(static_cast<double>(spec_.fov_degrees) * M_PI / 360);
  std::set<std::tuple<int, int>> seen;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const Vec3d w = ToDouble(camera_.GenerateRay(plane.PointOf(x, y, {})).direction);
      const Vec3d across = Cross(middle, right), along = Cross(up, middle);
      const double depth = Dot(w, Cross(right, up)) / Dot(middle, Cross(right, up));
      const double image_x = Dot(w, along) / Dot(right, along) / depth / reach;
      const double image_y = Dot(w, across) / Dot(up, across) / depth / reach;
      const auto pixel = [](double position) {
        return static_cast<int>(std::floor((position + 1) / 2 * kSize));
      };
      EXPECT_EQ(pixel(image_x), x);
      EXPECT_EQ(pixel(-image_y), y);
      seen.insert({pixel(image_x), pixel(-image_y)});
    }
  }
  EXPECT_EQ(seen.size(), size_t{kSize} * kSize);
}

/// Such cameras, as they are and with lenses.
std::vector<PerspectiveCamera> WithLenses(CameraSpec spec) {
  std::vector<PerspectiveCamera> cameras{PerspectiveCamera(spec)};
  for (const int blades : {0, 5}) {
    spec.aperture = 0.25f;
    spec.focus_distance = 3;
    spec.blades = blades;
    cameras.emplace_back(spec);
  }
  return cameras;
}

// From any point of a ray the way back ends in the image point and on the part of the lens that the
// ray came from.
TEST_P(EveryView, ConnectInvertsGenerateRay) {
  UniformNumbers random(7);
  for (const PerspectiveCamera& camera : WithLenses(spec_)) {
    for (int i = 0; i < 10000; ++i) {
      const Vec2 image_point{2 * random.Next() - 1, 2 * random.Next() - 1};
      const Vec2 u = random.NextPair();
      const Ray ray = camera.GenerateRay(image_point, u);
      const float distance = 0.5f + 20 * random.Next();
      const Vec3 p = ray.At(distance);
      const auto connection = camera.Connect(p, u);
      ASSERT_TRUE(connection);
      // Far from the origin a point is so inexact, seen in units of the image.
      const float rounding = (Length(p) + Length(ray.origin)) * 3e-7f / distance;
      ASSERT_LT(Length(connection->direction + ray.direction), 3e-6f + rounding);
      ASSERT_NEAR(connection->distance, distance, 1e-5f * distance + rounding);
      const float reach = std::tan(spec_.fov_degrees * static_cast<float>(M_PI) / 360);
      const float steep =
          1 / std::max(0.1f, Dot(ray.direction, camera.GenerateRay({0, 0}).direction));
      const float tolerance =
          (2e-5f + 10 * rounding * steep) * std::max(1.0f, 1 / reach) * std::max(1.0f, reach);
      ASSERT_NEAR(connection->image_point.x, image_point.x, tolerance);
      ASSERT_NEAR(connection->image_point.y, image_point.y, tolerance);
    }
  }
}

// The importance is that of a small part of the image plane: its area over the solid angle that its
// rays through the same point of the lens cover, as a point at that distance is seen.
TEST_P(EveryView, ImportanceIsTheJacobianOfItsRays) {
  UniformNumbers random(8);
  for (const PerspectiveCamera& camera : WithLenses(spec_)) {
    for (int i = 0; i < 1000; ++i) {
      const Vec2 at{2 * random.Next() - 1, 2 * random.Next() - 1};
      const Vec2 u = random.NextPair();
      constexpr float kStep = 0x1p-6f;
      const auto direction = [&](float x, float y) {
        return ToDouble(camera.GenerateRay({at.x + x, at.y + y}, u).direction);
      };
      // Central differences of two steps: what remains is of fourth order.
      const auto slope = [&](float x, float y) {
        const Vec3d near = direction(x, y) - direction(-x, -y);
        const Vec3d far = direction(2 * x, 2 * y) - direction(-2 * x, -2 * y);
        return (near * 8.0 - far) * (1 / (12.0 * static_cast<double>(kStep)));
      };
      const double solid_angle = Length(Cross(slope(kStep, 0), slope(0, kStep)));
      const Ray ray = camera.GenerateRay(at, u);
      const float distance = 0.5f + 5 * random.Next();
      const auto connection = camera.Connect(ray.At(distance), u);
      ASSERT_TRUE(connection);
      const double expected = 1 / (solid_angle * static_cast<double>(distance) * distance);
      // Points far from the origin are inexact, and wide pictures see that where they are
      // stretched.
      const float reach = std::tan(spec_.fov_degrees * static_cast<float>(M_PI) / 360);
      const float rounding = Length(ray.At(distance)) * 1.2e-7f / distance;
      ASSERT_NEAR(static_cast<double>(connection->importance) / expected, 1,
                  0.002f + 5 * std::max(1.0f, reach) * rounding);
    }
  }
}

TEST_P(EveryView, NothingBehindItIsConnected) {
  const Vec3 view = camera_.GenerateRay({0, 0}).direction;
  for (const PerspectiveCamera& camera : WithLenses(spec_)) {
    EXPECT_FALSE(camera.Connect(spec_.center - view, {0.5f, 0.5f}));
    EXPECT_TRUE(camera.Connect(spec_.center + view, {0.5f, 0.5f}));
  }
  EXPECT_FALSE(camera_.Connect(spec_.center, {0.5f, 0.5f})) << "from where it stands";
}

}  // namespace
}  // namespace candela
