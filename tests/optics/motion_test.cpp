// What moves while the shutter is open: objects, meshes that change, the camera.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "integrators/shutter_times.h"
#include "math/elementary.h"
#include "tests/optics/bright_scene.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::CompileText;

/// What shines, at places that are keyframes.
std::string MovingBar(const std::string& keyframes, const std::string& shape) {
  return fmt::format(
      "Node {{ Keyframes {{ {} }} Component<Object> {{ type {} }} Component<Material> {{ index 0 }}"
      " Component<Light> {{ type area radiance 1 1 1 }} }}\n",
      keyframes, shape);
}

/// The right edge of a bar at z = -1 goes from x = -0.5 to 0.5, of a picture from -1 to 1.
const char* kWay = "Transform { translate -2.5 0 -1 } Transform { translate -1.5 0 -1 }";
const char* kBar = "rectangle width 4 height 4";

/// A strip 64 pixels wide, with nothing smoothed but by the pixels and by time.
Image Strip(const Scene& scene) {
  return test::Seen(scene, test::Picture(64, 4, "box", 1024));
}

/// How bright that bar makes what lies from x - h to x + h, in the part of the time from `open` to
/// `close`: what its edge has come to, in the mean.
double Ramp(double x, double open = 0, double close = 1) {
  const auto passed = [&](double at) {
    return std::clamp((close - (at + 0.5)) / (close - open), 0.0, 1.0);
  };
  double sum = 0;
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) sum += passed(x + ((i + 0.5) / kSteps - 0.5) * 2 / 64);
  return sum / kSteps;
}

void ExpectRamp(const Image& strip, double open = 0, double close = 1) {
  for (int y = 0; y < strip.Height(); ++y) {
    for (int x = 0; x < strip.Width(); ++x) {
      const double at = (x + 0.5) / 32 - 1;
      EXPECT_NEAR(static_cast<double>(strip.At(x, y)), Ramp(at, open, close), 0.01)
          << x << " " << y;
    }
  }
}

/// A strip as wide as two units at the distance 1: the field of view counts vertically.
constexpr double kFov = 2 * 3.5763343749973514;  // 2 atan(1/16)

// P14: over dark ground a bright bar that moves makes a ramp that is linear to 1 percent.
TEST(MotionBlur, OfABarIsALinearRamp) {
  ExpectRamp(Strip(*test::SceneOf(MovingBar(kWay, kBar), kFov)));
}

// The shutter is open for a part of the time only.
TEST(MotionBlur, IsThatOfTheShutterInterval) {
  const auto scene = test::SceneOf(MovingBar(kWay, kBar), kFov, "shutter_interval 0.25 0.75");
  ExpectRamp(Strip(*scene), 0.25, 0.75);
}

// A bar that moves faster in the first half of the time: three keyframes.
TEST(MotionBlur, GoesFromKeyframeToKeyframe) {
  const auto scene = test::SceneOf(
      MovingBar("Transform { translate -2.5 0 -1 } Transform { translate -1.75 0 -1 } "
                "Transform { translate -1.5 0 -1 }",
                kBar),
      kFov);
  const Image strip = Strip(*scene);
  const auto at = [&](double x) {
    return static_cast<double>(strip.At(static_cast<int>((x + 1) * 32), 1));
  };
  // The middle of a pixel is a 64th to the right.
  EXPECT_NEAR(at(-0.125), 1 - (0.375 + 1.0 / 64) / 1.5, 0.01);
  EXPECT_NEAR(at(0.25), 0.5 - 1.0 / 64 / 0.5, 0.01);
  EXPECT_NEAR(at(0.375), 0.25 - 1.0 / 64 / 0.5, 0.01);
}

// Nodes in nodes: each half of the way, one in two parts, one in three.
TEST(MotionBlur, AddsUpAlongTheTree) {
  const std::string bar = test::Shining("translate -2 0 -1", kBar);
  const std::string inner = fmt::format(
      "Node {{ Keyframes {{ Transform {{ translate -0.25 0 0 }} Transform {{ translate 0 0 0 }} "
      "Transform {{ translate 0.25 0 0 }} }} {} }}",
      bar);
  const std::string nodes = fmt::format(
      "Node {{ Keyframes {{ Transform {{ translate -0.25 0 0 }} Transform {{ matrix 1 0 0 "
      "-0.08333333 0 1 0 0 0 0 1 0 }} Transform {{ translate 0.08333333 0 0 }} Transform {{ "
      "translate 0.25 0 0 }} }} {} }}",
      inner);
  const auto scene = test::SceneOf(nodes, kFov);
  EXPECT_EQ(scene->objects()[0].space->steps().size(), 7u);
  ExpectRamp(Strip(*scene));
}

// The camera goes the other way, and sees the same.
TEST(MotionBlur, OfACameraIsThatOfTheOppositeScene) {
  const auto scene =
      test::SceneOf(test::Shining("translate -2.5 0 -1", kBar), kFov, "center_end -1 0 0");
  ASSERT_TRUE(scene->IsMoving());
  ExpectRamp(Strip(*scene));
}

/// A picture with shadows, bounces and a lamp, whose camera is that of `camera`.
std::string Room(const std::string& camera, const std::string& around) {
  return fmt::format(
      "Camera {{ center 0 1 5 direction 0 -0.1 -1 up 0 1 0 fov 40 {} }}\n"
      "Materials {{ Material {{ name grey type diffuse albedo 0.6 0.5 0.4 }}\n"
      "Material {{ name glass type dielectric ior 1.5 }} }}\n"
      "Scene {{ Node {{ {}\n"
      "Node {{ Component<Material> {{ name grey }} Component<Object> {{ type rectangle width 8 "
      "height 8 }} Transform {{ x_rotate -90 }} }}\n"
      "Node {{ Component<Material> {{ name grey }} Component<Object> {{ type sphere radius 0.5 }} "
      "Transform {{ translate -0.5 0.5 0 }} }}\n"
      "Node {{ Component<Material> {{ name glass }} Component<Object> {{ type mesh obj_file "
      "assets/assignment4/models/cube.obj }} Transform {{ translate 0.8 0.6 0 scale 0.4 0.4 0.4 }} "
      "}}\n"
      "Node {{ Component<Material> {{ name grey }} Component<Object> {{ type sphere radius 1 }} "
      "Component<Light> {{ type area radiance 9 9 9 }} Transform {{ translate 1 3 1 }} }}\n"
      "}} }}",
      camera, around);
}

Image RoomSeen(const std::string& camera, const std::string& around, uint32_t samples) {
  const auto scene = CompileText(Room(camera, around));
  if (!scene) return {};
  return testing_support::RenderImage(PathIntegrator(*scene, {}),
                                      test::Picture(32, 24, "box", samples));
}

double MeanOf(const Image& image) {
  double sum = 0;
  for (const float value : image.Samples()) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.Samples().size());
}

/// Of the means of columns, as a part of all light: what rounding changes goes other ways.
double DifferenceOfColumns(const Image& a, const Image& b) {
  double off = 0, sum = 0;
  for (int x = 0; x < a.Width(); ++x) {
    double of_a = 0, of_b = 0;
    for (int y = 0; y < a.Height(); ++y) {
      for (int c = 0; c < 3; ++c) {
        of_a += static_cast<double>(a.At(x, y, c));
        of_b += static_cast<double>(b.At(x, y, c));
      }
    }
    off += std::abs(of_a - of_b);
    sum += of_b;
  }
  return off / sum;
}

TEST(MotionBlur, OfACameraInARoomIsThatOfTheOppositeRoom) {
  const Image camera = RoomSeen("center_end 1.5 1 5", "", 64);
  const Image room = RoomSeen(
      "", "Keyframes { Transform { translate 0 0 0 } Transform { translate -1.5 0 0 } }", 512);
  const Image rest = RoomSeen("", "", 64),
              end = RoomSeen("", "Transform { translate -1.5 0 0 }", 64);
  // Its lamp is found by rays alone, which is noisier.
  const double off = DifferenceOfColumns(room, camera);
  EXPECT_LT(off, 0.06);
  // A room that stood still, or jumped to its end, would be seen.
  EXPECT_GT(DifferenceOfColumns(rest, camera), 3 * off);
  EXPECT_GT(DifferenceOfColumns(end, camera), 3 * off);
}

// A shutter that opens for a moment freezes what is there, and draws no number for it. All but the
// lamp, which can be sampled only where it rests.
TEST(FrozenShutter, ShowsTheSceneAtThatMoment) {
  const auto freeze = [](const std::string& camera, const std::string& place) {
    return test::Seen(*test::SceneOf(MovingBar(place, "sphere radius 0.7"), 90, camera),
                      test::Picture(32, 32, "box", 16));
  };
  const Image frozen = freeze("shutter_interval 0.25 0.25",
                              "Transform { translate 0 0 -4 } Transform { translate 4 0 -4 }");
  const Image rest =
      test::Seen(*test::SceneOf(test::Shining("translate 1 0 -4", "sphere radius 0.7"), 90),
                 test::Picture(32, 32, "box", 16));
  EXPECT_GT(MeanOf(rest), 0.01);
  EXPECT_TRUE(frozen == rest);
  EXPECT_FALSE(freeze("shutter_interval 0 0.25",
                      "Transform { translate 0 0 -4 } Transform { translate 4 0 -4 }") == rest);
}

TEST(FrozenShutter, ShowsWhatTheCameraSeesAtThatMoment) {
  const auto frozen =
      CompileText(Room("shutter_interval 0.5 0.5 center_end 1 2 5 direction_end 0.5 -0.1 -1", ""));
  std::string at_rest = Room("", "");
  at_rest.replace(at_rest.find("center 0 1 5 direction 0 "), 25,
                  "center 0.5 1.5 5 direction 0.25 ");
  const auto rest = CompileText(at_rest);
  ASSERT_TRUE(frozen && rest);
  const auto options = test::Picture(32, 24, "box", 16);
  EXPECT_TRUE(testing_support::RenderImage(PathIntegrator(*frozen, {}), options) ==
              testing_support::RenderImage(PathIntegrator(*rest, {}), options));
}

// A turn by 90 degrees is no straight way: it is cut into parts of at most 4 degrees.
TEST(Keyframes, TurnByTheirAngles) {
  const auto scene = CompileText(
      std::string(testing_support::kCamera) +
      "Materials { Material { diffuse 1 1 1 } } Scene { Keyframes { Transform { translate 0 0 -5 "
      "y_rotate 0 } Transform { translate 0 0 -5 y_rotate 80 } } Component<Material> { index 0 } "
      "Component<Object> { type rectangle width 4 height 4 } }");
  ASSERT_TRUE(scene);
  for (const float time : {0.0f, 0.3f, 0.51f, 0.9f, 1.0f}) {
    Ray ray({0.1f, 0.2f, 0}, {0, 0, -1});
    ray.time = time;
    HitRecord hit;
    ASSERT_TRUE(scene->Intersect(ray, &hit)) << time;
    const double angle = 80 * static_cast<double>(time);
    const double z = -5 - 0.1 * TanDegrees(angle);
    EXPECT_NEAR(static_cast<double>(hit.t), -z, 1e-3) << time;
    for (const SurfacePoint& point : {scene->SurfaceAt(ray, hit), scene->ShadingAt(ray, hit)}) {
      EXPECT_NEAR(static_cast<double>(point.n_shading.x), SinDegrees(angle), 1e-3);
      EXPECT_NEAR(static_cast<double>(point.n_shading.z), CosDegrees(angle), 1e-3);
      EXPECT_NEAR(Length(point.n_shading), 1, 1e-6);
      EXPECT_NEAR(point.p.z, -hit.t, 1e-5);
    }
  }
}

/// Two triangles that are 4 wide and high, with their left edge at x.
std::string Quad(double x) {
  return fmt::format("v {0} -2 0\nv {1} -2 0\nv {1} 2 0\nv {0} 2 0\nf 1 2 3 4\n", x, x + 4);
}

TEST(DeformingMesh, GoesFromOneFileToTheOther) {
  const testing_support::TempFolder folder;
  testing_support::Put(folder / "a.obj", Quad(-4.5));
  testing_support::Put(folder / "b.obj", Quad(-3.5));
  testing_support::Put(folder / "also_a.obj", Quad(-4.5));
  const auto seen = [&](const std::string& files) {
    const auto scene = CompileText(
        fmt::format(
            "Camera {{ center 0 0 1 direction 0 0 -1 up 0 1 0 fov {} }} Background {{ color "
            "0 0 0 }} Materials {{ Material {{ type diffuse }} }} Scene {{ "
            "Component<Material> {{ index 0 }} Component<Object> {{ type mesh {} }} "
            "Component<Light> {{ type area }} }}",
            kFov, files),
        folder.path());
    return scene ? Strip(*scene) : Image();
  };
  ExpectRamp(seen("obj_file a.obj obj_file_end b.obj"));
  EXPECT_TRUE(seen("obj_file a.obj obj_file_end also_a.obj") == seen("obj_file a.obj"));
}

// P14: a shutter that is open from 0.2 to 0.7 takes as many samples in each part of this time: by
// chi-square over the pixels, and within a pixel one of 64 samples in each 64th.
TEST(Shutter, IsEvenlyOpen) {
  const auto scene = test::SceneOf(MovingBar(kWay, kBar), kFov, "shutter_interval 0.2 0.7");
  const ShutterTimes times(*scene, 7, {});
  ASSERT_TRUE(times.AreNeeded());
  constexpr int kBins = 32, kSide = 64;
  std::array<int, kBins> counts{};
  const auto part = [&](const SampleRequest& sample, int parts) {
    return static_cast<int>((static_cast<double>(times.Draw(sample)) - 0.2) / 0.5 * parts);
  };
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      const int bin = part({x, y, 3, {}}, kBins);
      ASSERT_TRUE(bin >= 0 && bin < kBins);
      ++counts[static_cast<size_t>(bin)];
    }
  }
  const double expected = double{kSide} * kSide / kBins;
  double chi_square = 0;
  for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_square, 82);  // With 31 degrees of freedom more than that has a chance of 2e-6.

  std::vector<int> strata(64);
  // Rounding moves few times across a border.
  for (uint32_t i = 0; i < 64; ++i) ++strata[static_cast<size_t>(part({5, 6, i, {}}, 64))];
  EXPECT_LE(std::count(strata.begin(), strata.end(), 0), 2);
}

// Without motion nothing is drawn, and no ray has another time than 0.
TEST(Shutter, IsNotAskedForWhereNothingMoves) {
  const auto scene = test::SceneOf(test::Shining("translate 0 0 -1", kBar), kFov);
  EXPECT_FALSE(scene->IsMoving());
  EXPECT_FALSE(ShutterTimes(*scene, 0, {}).AreNeeded());
}

}  // namespace
}  // namespace candela
