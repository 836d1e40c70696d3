#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cameras/perspective_camera.h"
#include "math/elementary.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

/// Looks along -z from the origin, with a lens of radius 0.1 focused at 5.
CameraSpec Lens(int blades = 0) {
  CameraSpec spec{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90};
  spec.aperture = 0.2f;
  spec.focus_distance = 5;
  spec.blades = blades;
  return spec;
}

TEST(ThinLens, RaysOfAPixelMeetInTheFocusPlane) {
  const PerspectiveCamera camera(Lens());
  UniformNumbers numbers(1);
  for (const Vec2 image_point : {Vec2{0, 0}, Vec2{0.5f, -0.25f}, Vec2{1, 1}}) {
    for (int i = 0; i < 1000; ++i) {
      const Ray ray = camera.GenerateRay(image_point, numbers.NextPair());
      EXPECT_NEAR(Length(ray.direction), 1, 2e-7);
      EXPECT_NEAR(ray.origin.z, 0, 1e-7);
      const Vec3 p = ray.At((-5 - ray.origin.z) / ray.direction.z);
      ASSERT_NEAR(p.x, 5 * image_point.x, 4e-6);
      ASSERT_NEAR(p.y, 5 * image_point.y, 4e-6);
    }
  }
}

// P14, CF25: a point at distance D = 10 is seen through every part of the lens from directions that
// meet the focus plane in a disk of diameter 2 a |D - F| / D = 0.1.
TEST(ThinLens, BlursAPointToADiskOfTheClosedForm) {
  const PerspectiveCamera camera(Lens());
  UniformNumbers numbers(2);
  float widest = 0;
  for (int i = 0; i < 100000; ++i) {
    // Where the ray from the lens to the point passes the focus plane.
    const Ray ray = camera.GenerateRay({0, 0}, numbers.NextPair());
    const Vec3 point{0, 0, -10};
    const Vec3 to_point = point - ray.origin;
    const Vec3 in_focus = ray.origin + to_point * (5 / 10.0f);
    widest = std::max(widest, 2 * std::sqrt(in_focus.x * in_focus.x + in_focus.y * in_focus.y));
  }
  EXPECT_NEAR(widest, 0.1, 1e-4);
}

// The same as a share of film: a sphere in focus is sharp, its rim lies where a pinhole has it.
TEST(ThinLens, OfNoDiameterIsAPinhole) {
  CameraSpec spec = Lens();
  spec.aperture = 0;
  const PerspectiveCamera camera(spec);
  EXPECT_TRUE(camera.IsPinhole());
  const Ray ray = camera.GenerateRay({0.3f, 0.4f}, {0.7f, 0.1f});
  EXPECT_EQ(ray.origin, camera.GenerateRay({0.3f, 0.4f}).origin);
  EXPECT_EQ(ray.direction, camera.GenerateRay({0.3f, 0.4f}).direction);
}

// P1
TEST(ThinLens, IsEvenlyCovered) {
  const PerspectiveCamera camera(Lens());
  constexpr size_t kRings = 16, kSectors = 24;
  UniformNumbers numbers(3);
  std::vector<uint64_t> counts(kRings * kSectors);
  for (int i = 0; i < 1000000; ++i) {
    const Vec3 p = camera.GenerateRay({0, 0}, numbers.NextPair()).origin;
    const double squared = (double{p.x} * p.x + double{p.y} * p.y) / 0.01;
    const double turn = Atan2(double{p.y}, double{p.x}) / (2 * kPi) + 0.5;
    const size_t ring = std::min(static_cast<size_t>(squared * kRings), kRings - 1);
    const size_t sector = std::min(static_cast<size_t>(turn * kSectors), kSectors - 1);
    ++counts[ring * kSectors + sector];
  }
  const std::vector<double> shares(counts.size(), 1.0 / static_cast<double>(counts.size()));
  EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate);
}

// P1: the opening of a shutter of n blades: a regular polygon in the round opening, one corner on
// top.
TEST(ThinLens, OfBladesIsAnEvenlyCoveredPolygon) {
  for (const int blades : {3, 5, 6}) {
    const PerspectiveCamera camera(Lens(blades));
    UniformNumbers numbers(4);
    constexpr size_t kSteps = 40;
    const double inner = CosDegrees(180.0 / blades);
    std::vector<uint64_t> counts(kSteps);
    double top = 0;
    for (int i = 0; i < 200000; ++i) {
      const Vec3 p = camera.GenerateRay({0, 0}, numbers.NextPair()).origin * 10.0f;
      top = std::max(top, double{p.y});
      // The distance of the side beyond which it is, as a part of that of the sides.
      double farthest = 0;
      for (int side = 0; side < blades; ++side) {
        const double degrees = 90 + 360.0 * (side + 0.5) / blades;
        farthest = std::max(farthest,
                            CosDegrees(degrees) * double{p.x} + SinDegrees(degrees) * double{p.y});
      }
      const double part = farthest / inner;
      ASSERT_LE(part, 1 + 1e-6);
      // Polygons of equal shape: area goes by the square.
      ++counts[std::min(static_cast<size_t>(part * part * kSteps), kSteps - 1)];
    }
    EXPECT_GT(top, 0.98) << "no corner is on top";
    const std::vector<double> shares(kSteps, 1.0 / kSteps);
    EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate) << blades;
  }
}

}  // namespace
}  // namespace candela
