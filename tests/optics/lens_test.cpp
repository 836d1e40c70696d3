// What a lens makes of a point that is not in focus.

#include <gtest/gtest.h>

#include <cmath>

#include "math/elementary.h"
#include "tests/optics/bright_scene.h"

namespace candela {
namespace {

struct Spot {
  double x = 0, y = 0;  ///< The centroid.
  double spread = 0;    ///< The mean squared distance from it.
  double brightness = 0;
};

/// The spot in a picture that is `width` units wide; in these units, from the middle.
Spot SpotOf(const Image& image, double width) {
  const double pixel = width / image.Width();
  Spot spot;
  const auto sum = [&](const auto& value) {
    double total = 0;
    for (int y = 0; y < image.Height(); ++y) {
      for (int x = 0; x < image.Width(); ++x) {
        const double right = (x + 0.5 - image.Width() / 2.0) * pixel;
        const double up = (image.Height() / 2.0 - y - 0.5) * pixel;
        total += static_cast<double>(image.At(x, y)) * value(right, up);
      }
    }
    return total;
  };
  spot.brightness = sum([](double, double) { return 1.0; });
  spot.x = sum([](double x, double) { return x; }) / spot.brightness;
  spot.y = sum([](double, double y) { return y; }) / spot.brightness;
  spot.spread = sum([&](double x, double y) {
                  return (x - spot.x) * (x - spot.x) + (y - spot.y) * (y - spot.y);
                }) /
                spot.brightness;
  // The area of a pixel has a spread of its own, a sixth of its square.
  spot.spread -= pixel * pixel / 6;
  return spot;
}

// P14, CF25: a lens of radius a = 0.1 that is focused at F = 5 makes of a point at D a disk of
// diameter 2 a |D - F| / D in the plane of focus: 0.1 for D = 10. The mean squared distance from
// the middle of an even disk is half of the square of its radius. The point is a disk itself, of
// radius 0.02, which adds its own.
TEST(Lens, BlursAPointToADiskOfItsOpeningTimesTheDefocus) {
  constexpr double kLens = 0.1, kFocus = 5, kPoint = 0.02;
  // The picture is 0.16 units wide in the plane of focus.
  constexpr double kWidth = 0.16;
  const double fov = 2 * std::atan(kWidth / 2 / kFocus) * 180 / kPi;
  for (const double distance : {10.0, 4.0}) {
    const auto scene =
        test::SceneOf(test::Shining(fmt::format("translate 0 0 -{}", distance),
                                    fmt::format("disk radius {}", kPoint * distance / kFocus / 2)),
                      fov, "aperture 0.2 focus_distance 5");
    const Image image = test::Seen(*scene, test::Picture(64, 64, "box", 1024));
    const Spot spot = SpotOf(image, kWidth);
    const double diameter = 2 * kLens * std::abs(distance - kFocus) / distance;
    const double expected = (diameter / 2) * (diameter / 2) / 2 + kPoint * kPoint / 4 / 2;
    EXPECT_NEAR(spot.spread, expected, 0.01 * expected) << distance;
    EXPECT_NEAR(spot.x, 0, 0.002 * kWidth) << distance;
    EXPECT_NEAR(spot.y, 0, 0.002 * kWidth) << distance;
  }
}

// CF25: the same in `whitted`, when it is asked to look through the lens; else the point is as
// large as it is.
TEST(Lens, BlursInWhittedOnlyWithDepthOfField) {
  constexpr double kWidth = 0.16, kPoint = 0.02;
  const double fov = 2 * std::atan(kWidth / 2 / 5) * 180 / kPi;
  const auto scene =
      test::SceneOf(test::Shining("translate 0 0 -10", fmt::format("disk radius {}", kPoint)), fov,
                    "aperture 0.2 focus_distance 5");
  for (const bool depth_of_field : {false, true}) {
    IntegratorOptions options;
    options.depth_of_field = depth_of_field;
    const auto integrator = CreateIntegrator("whitted", *scene, options);
    ASSERT_TRUE(integrator);
    const Spot spot = SpotOf(
        testing_support::RenderImage(**integrator, test::Picture(64, 64, "box", 1024)), kWidth);
    // Seen in the plane of focus the disk is half as large.
    const double of_point = kPoint * kPoint / 4 / 2;
    const double expected = (depth_of_field ? 0.05 * 0.05 / 2 : 0) + of_point;
    EXPECT_NEAR(spot.spread, expected, 0.01 * expected);
  }
}

// P14: of a point in focus nothing is blurred: it is as large as it is.
TEST(Lens, ShowsWhatIsInFocusAsAPinholeDoes) {
  const std::string point = test::Shining("translate 0 0 -5", "disk radius 0.03");
  const double fov = 2 * std::atan(0.016) * 180 / kPi;
  const auto lens = test::SceneOf(point, fov, "aperture 0.2 focus_distance 5");
  const auto pinhole = test::SceneOf(point, fov);
  const RenderOptions options = test::Picture(64, 64, "box", 256);
  const Spot sharp = SpotOf(test::Seen(*pinhole, options), 0.16);
  const Spot spot = SpotOf(test::Seen(*lens, options), 0.16);
  EXPECT_NEAR(sharp.spread, 0.00045, 0.00045 * 2e-3);
  EXPECT_NEAR(spot.spread, sharp.spread, 2e-3 * sharp.spread);
  EXPECT_NEAR(spot.brightness, sharp.brightness, 1e-3 * sharp.brightness);
}

}  // namespace
}  // namespace candela
