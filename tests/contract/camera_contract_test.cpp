// What holds for every kind of camera, wherever it stands.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cameras/image_plane.h"
#include "tests/contract/rows.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

constexpr const char* kViews[] = {
    "center 0 0 10 direction 0 0 -1 up 0 1 0",
    "center 1 2 3 direction 5 -1 2 up 0 1 0",
    "center -7 0 0 direction 0 0 3 up 0 2 1",
};
/// What rows can do beside their examples.
constexpr CameraEntry kVariants[] = {
    {"view_camera", nullptr,
     "type perspective fov 60 aperture 0.3 focus_distance 4 blades 5 blade_rotation 20 "
     "tilt -30 55 shift 0.4 -0.7"},
    {"pinhole", nullptr, "type perspective fov 100"},
    {"parallel", nullptr, "type orthographic height 7"},
    {"whole_sphere", nullptr, "type fisheye mapping equisolid fov 360"},
    {"equidistant", nullptr, "type fisheye fov 250"},
    {"strip", nullptr, "type panoramic fov 60"},
};

std::vector<CameraEntry> Rows() {
  std::vector<CameraEntry> rows(CameraEntries().begin(), CameraEntries().end());
  rows.insert(rows.end(), std::begin(kVariants), std::end(kVariants));
  return rows;
}

class EveryCamera : public testing::TestWithParam<CameraEntry> {
 protected:
  /// One for each view.
  static std::vector<std::unique_ptr<const Scene>> Scenes() {
    std::vector<std::unique_ptr<const Scene>> scenes;
    for (const char* view : kViews) {
      scenes.push_back(testing_support::CompileText(
          fmt::format("Camera {{ {} {} }} Scene {{ }}", view, GetParam().example)));
    }
    return scenes;
  }
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryCamera, testing::ValuesIn(Rows()),
                         contract::RowName<CameraEntry>);

/// A point of a picture twice as wide as it is high.
Vec2 RandomPoint(UniformNumbers* random) {
  const Vec2 u = random->NextPair();
  return {4 * u.x - 2, 2 * u.y - 1};
}

/// How far points are from where they should be, by rounding.
float Rounding(Vec3 p, Vec3 q) {
  return 3e-7f * (Length(p) + Length(q) + 1);
}

bool SeesNothing(const Ray& ray) {
  return ray.direction == Vec3();
}

TEST_P(EveryCamera, DirectionsAreUnitVectorsOrNone) {
  for (const auto& scene : Scenes()) {
    UniformNumbers random(1);
    int count = 0;
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = scene->camera().GenerateRay(RandomPoint(&random), random.NextPair());
      EXPECT_EQ(ray.t_min, 0);
      EXPECT_EQ(ray.mask, uint32_t{kCameraRay});
      if (SeesNothing(ray)) continue;
      ASSERT_NEAR(Length(ray.direction), 1, 3e-7);
      ++count;
    }
    EXPECT_GT(count, 700) << "of the picture nothing is left";
  }
}

TEST_P(EveryCamera, ManyRaysAreThoseOfTheirPoints) {
  for (const auto& scene : Scenes()) {
    UniformNumbers random(6);
    std::vector<Vec2> points;
    for (int i = 0; i < 300; ++i) points.push_back(RandomPoint(&random) * 1.1f);
    std::vector<Ray> rays(points.size());
    const bool all_see = scene->camera().GenerateRays(points, rays.data());
    for (size_t i = 0; i < points.size(); ++i) {
      const Ray alone = scene->camera().GenerateRay(points[i]);
      EXPECT_EQ(rays[i].origin, alone.origin);
      EXPECT_EQ(rays[i].direction, alone.direction);
      EXPECT_EQ(rays[i].mask, alone.mask);
      EXPECT_EQ(rays[i].t_min, alone.t_min);
      EXPECT_EQ(rays[i].t_max, alone.t_max);
      if (all_see) {
        EXPECT_FALSE(SeesNothing(rays[i]));
      }
    }
  }
}

// Without a shift that is the direction of view, and what is in the middle there has its distance.
TEST_P(EveryCamera, TheMiddleIsTheDirectionOfView) {
  const std::string example(GetParam().example);
  const bool is_shifted = example.find("shift") != std::string::npos;
  for (const char* view : kViews) {
    const auto scene = testing_support::CompileText(
        fmt::format("Camera {{ {} {} {} }} Scene {{ }}", view,
                    example.substr(0, example.find("shift")), is_shifted ? "shift 0 0" : ""));
    float x, y, z, dx, dy, dz;
    ASSERT_EQ(std::sscanf(view, "center %f %f %f direction %f %f %f", &x, &y, &z, &dx, &dy, &dz),
              6);
    const Ray ray = scene->camera().GenerateRay({0, 0});
    EXPECT_EQ(ray.origin, (Vec3{x, y, z}));
    EXPECT_NEAR(Dot(ray.direction, Normalize(Vec3{dx, dy, dz})), 1, 1e-6);
    EXPECT_NEAR(scene->camera().DepthOf(ray.At(7)), 7, 1e-5);
  }
}

// Every part of the film that shows something is seen from where its ray goes, and no other part.
TEST_P(EveryCamera, RaysCoverTheFilmOnce) {
  constexpr int kWidth = 128, kHeight = 64;
  const ImagePlane plane(kWidth, kHeight, PixelGrid::kCentres, false);
  const Vec2 u{0.3f, 0.6f};
  for (const auto& scene : Scenes()) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Ray ray = scene->camera().GenerateRay(plane.PointOf(x, y, {}), u);
        if (SeesNothing(ray)) continue;
        const auto connection = scene->camera().Connect(ray.At(6), u);
        ASSERT_TRUE(connection) << x << " " << y;
        const Vec2 position = plane.PositionOf(connection->image_point);
        ASSERT_EQ(std::lround(position.x), x);
        ASSERT_EQ(std::lround(position.y), y);
      }
    }
  }
}

// From any point of a ray the way back ends in the image point and on the part of the lens that the
// ray came from.
TEST_P(EveryCamera, ConnectInvertsGenerateRay) {
  for (const auto& scene : Scenes()) {
    UniformNumbers random(2);
    for (int i = 0; i < 5000; ++i) {
      const Vec2 image_point = RandomPoint(&random);
      const Vec2 u = random.NextPair();
      const float distance = 0.5f + 20 * random.Next();
      const Ray ray = scene->camera().GenerateRay(image_point, u);
      // Rims and poles are lines to which a direction belongs as much as to others nearby.
      if (SeesNothing(ray) || std::abs(image_point.y) > 0.98f) continue;
      const Vec3 p = ray.At(distance);
      const auto connection = scene->camera().Connect(p, u);
      ASSERT_TRUE(connection);
      const float rounding = Rounding(p, ray.origin);
      ASSERT_LT(Length(connection->direction + ray.direction), 3e-6f + rounding / distance);
      ASSERT_NEAR(connection->distance, distance, 1e-5f * distance + rounding);
      const Ray again = scene->camera().GenerateRay(connection->image_point, u);
      ASSERT_LT(Length(again.origin + again.direction * distance - p), 20 * rounding);
      const float tolerance = 1e-4f + 300 * rounding / distance;
      ASSERT_NEAR(connection->image_point.x, image_point.x, tolerance);
      ASSERT_NEAR(connection->image_point.y, image_point.y, tolerance);
    }
  }
}

// The other way round: whatever point is said to be seen is met by the ray that sees it.
TEST_P(EveryCamera, GenerateRayInvertsConnect) {
  for (const auto& scene : Scenes()) {
    const Vec3 center = scene->camera().GenerateRay({0, 0}).origin;
    UniformNumbers random(3);
    int count = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec2 a = random.NextPair(), b = random.NextPair();
      const Vec3 p = center + Vec3{a.x - 0.5f, a.y - 0.5f, b.x - 0.5f} * 20.0f;
      const Vec2 u = random.NextPair();
      const auto connection = scene->camera().Connect(p, u);
      if (!connection || std::abs(connection->image_point.x) > 4 ||
          std::abs(connection->image_point.y) > 4)
        continue;
      ++count;
      const Ray ray = scene->camera().GenerateRay(connection->image_point, u);
      ASSERT_FALSE(SeesNothing(ray));
      ASSERT_LT(Length(ray.At(connection->distance) - p), 20 * Rounding(p, center));
    }
    EXPECT_GT(count, 300);
  }
}

// P14: a camera that moves is at each time the one that stands there: rays, and their way back.
TEST_P(EveryCamera, MovingIsAtEachTimeOneAtRest) {
  const auto with_view = [](const std::string& view) {
    return testing_support::CompileText(
        fmt::format("Camera {{ {} {} }} Scene {{ }}", view, GetParam().example));
  };
  const auto moving = with_view(
      "center 1 2 3 direction 4 -1 2 up 0 1 0 center_end 5 2 -1 direction_end 4 3 -2 up_end 1 1 0");
  const auto rest = with_view("center 2 2 2 direction 4 0 1 up 0.25 1 0");
  ASSERT_TRUE(moving && rest);
  EXPECT_TRUE(moving->IsMoving() && moving->camera().IsMoving());
  EXPECT_FALSE(rest->IsMoving() || rest->camera().IsMoving());
  const float time = 0.25f;
  UniformNumbers random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 image_point = RandomPoint(&random), u = random.NextPair();
    const Ray ray = moving->camera().GenerateRayAt(time, image_point, u);
    const Ray expected = rest->camera().GenerateRay(image_point, u);
    ASSERT_EQ(ray.origin, expected.origin);
    ASSERT_EQ(ray.direction, expected.direction);
    ASSERT_EQ(moving->camera().GenerateRayAt(time, image_point, {}).direction,
              rest->camera().GenerateRay(image_point).direction);
    const Vec3 p = expected.At(5);
    ASSERT_EQ(moving->camera().DepthAt(time, p), rest->camera().DepthOf(p));
    const auto way = moving->camera().ConnectAt(time, p, u);
    const auto expected_way = rest->camera().Connect(p, u);
    ASSERT_EQ(way.has_value(), expected_way.has_value());
    if (!way) continue;
    ASSERT_EQ(way->image_point, expected_way->image_point);
    ASSERT_EQ(way->importance, expected_way->importance);
  }
}

// The importance is the area of a small part of the image plane over the area that its rays through
// the same point of the lens cover, across the one in their middle.
TEST_P(EveryCamera, ImportanceIsTheJacobianOfItsRays) {
  for (const auto& scene : Scenes()) {
    UniformNumbers random(4);
    for (int i = 0; i < 1000; ++i) {
      const Vec2 at = RandomPoint(&random) * 0.9f;
      const Vec2 u = random.NextPair();
      const float distance = 0.5f + 5 * random.Next();
      constexpr float kStep = 0x1p-6f;
      const Ray ray = scene->camera().GenerateRay(at, u);
      if (SeesNothing(ray) || Length(Vec3{at.x, at.y, 0}) > 0.9f) continue;
      const Vec3d w = ToDouble(ray.direction);
      const Vec3d p = ToDouble(ray.origin) + w * static_cast<double>(distance);
      // Where the ray of an image point nearby meets the plane through p across the ray.
      const auto place = [&](float x, float y) {
        const Ray near = scene->camera().GenerateRay({at.x + x, at.y + y}, u);
        const Vec3d o = ToDouble(near.origin), d = ToDouble(near.direction);
        return o + d * (Dot(p - o, w) / Dot(d, w));
      };
      // Central differences of two steps: what remains is of fourth order.
      const auto slope = [&](float x, float y) {
        const Vec3d near = place(x, y) - place(-x, -y);
        const Vec3d far = place(2 * x, 2 * y) - place(-2 * x, -2 * y);
        return (near * 8.0 - far) * (1 / (12.0 * static_cast<double>(kStep)));
      };
      const double area = Length(Cross(slope(kStep, 0), slope(0, kStep)));
      const auto connection = scene->camera().Connect(ToFloat(p), u);
      ASSERT_TRUE(connection);
      ASSERT_NEAR(static_cast<double>(connection->importance) * area, 1, 0.002)
          << at.x << " " << at.y;
    }
  }
}

// Where the picture goes on around, the others see the same.
TEST_P(EveryCamera, RepeatsSeeTheSame) {
  for (const auto& scene : Scenes()) {
    const Camera& camera = scene->camera();
    UniformNumbers random(5);
    std::vector<Vec2> others;
    for (int i = 0; i < 1000; ++i) {
      const Vec2 image_point = RandomPoint(&random);
      others.clear();
      camera.AddRepeats(image_point, &others);
      EXPECT_EQ(!others.empty(), camera.Repeats());
      for (const Vec2 other : others) {
        EXPECT_NE(other, image_point);
        EXPECT_LT(
            Length(camera.GenerateRay(other).direction - camera.GenerateRay(image_point).direction),
            2e-6f);
      }
    }
  }
}

TEST_P(EveryCamera, FootprintIsHowFarNeighboursInTheMiddleAreApart) {
  const std::string example(GetParam().example);
  if (example.find("shift") != std::string::npos) return;  // The middle of the picture is aside.
  const auto scenes = Scenes();                            // In the first one `up` is not slanted.
  const Camera& camera = scenes[0]->camera();
  constexpr float kStep = 0x1p-8f, kFar = 64;
  const Ray a = camera.GenerateRay({0, -kStep}), b = camera.GenerateRay({0, kStep});
  const CameraFootprint footprint = camera.FootprintPerUnit();
  EXPECT_NEAR(Length(a.origin - b.origin), 2 * kStep * footprint.width, 2e-6);
  EXPECT_NEAR(Length(a.At(kFar) - b.At(kFar)),
              2 * kStep * (footprint.width + footprint.spread * kFar), 1e-3);
}

TEST_P(EveryCamera, IsNotSeenByItself) {
  for (const auto& scene : Scenes()) {
    const Camera& camera = scene->camera();
    if (!camera.IsPinhole()) continue;
    EXPECT_FALSE(camera.Connect(camera.GenerateRay({0, 0}).origin, {0.5f, 0.5f}));
  }
}

TEST_P(EveryCamera, SaysInWordsWhereItStands) {
  const auto scenes = Scenes();
  EXPECT_EQ(scenes[0]->camera().Description().rfind("at 0 0 10, direction 0 0 -1, up 0 1 0, ", 0),
            0u);
}

}  // namespace
}  // namespace candela
