// What holds for the camera. There is one kind; it has to hold however it stands.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "cameras/image_plane.h"
#include "cameras/perspective_camera.h"

namespace candela {
namespace {

class EveryCamera : public testing::TestWithParam<CameraSpec> {
 protected:
  const CameraSpec& spec_ = GetParam();
  const PerspectiveCamera camera_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Views, EveryCamera,
                         testing::Values(CameraSpec{{0, 0, 10}, {0, 0, -1}, {0, 1, 0}, 30},
                                         CameraSpec{{1, 2, 3}, {5, -1, 2}, {0, 1, 0}, 90},
                                         CameraSpec{{-7, 0, 0}, {0, 0, 3}, {0, 2, 1}, 1},
                                         CameraSpec{{0, 1e4f, 0}, {0, -1, 0}, {1, 0, 0}, 170}));

TEST_P(EveryCamera, TheRayInTheMiddleIsTheDirectionOfView) {
  const Ray ray = camera_.GenerateRay({0, 0});
  EXPECT_EQ(ray.origin, spec_.center);
  EXPECT_NEAR(Dot(ray.direction, NormalizeAnyLength(spec_.direction)), 1, 1e-6);
  EXPECT_EQ(ray.t_min, 0.0f);
}

TEST_P(EveryCamera, DirectionsAreUnitVectors) {
  for (const Vec2 p : {Vec2{0, 0}, Vec2{1, 1}, Vec2{-1, 0.5f}, Vec2{0.1f, -0.9f}}) {
    EXPECT_NEAR(Length(camera_.GenerateRay(p).direction), 1, 2e-7);
  }
}

// Projected back, the ray of a pixel ends in that pixel: every part of the film is seen, and once.
TEST_P(EveryCamera, RaysCoverTheFilmOnce) {
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

}  // namespace
}  // namespace candela
