// How large a sphere looks: its rim lies asin(r / d) off the line to its centre.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "render/render_first_hits.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

/// The pixels of an 800 x 800 picture that show the unit sphere from a distance of 10, with a field
/// of view of 30 degrees. Its share of the picture is (pi / 4) (tan(asin(1/10)) / tan 15)^2 =
/// 0.1104968.
int64_t PixelsOfTheSphere(PixelGrid grid) {
  const auto scene = testing_support::CompileText(
      "Camera { center 0 0 10 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Materials { Material { diffuse 1 1 1 } }\n"
      "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }");
  RenderOptions options;
  options.grid = grid;
  const std::vector<FirstHit> hits = RenderFirstHits(*scene, options);
  return std::count_if(hits.begin(), hits.end(), [](const FirstHit& hit) { return hit.is_hit; });
}

/// The share of a picture of 800 x 800 pixels that shows the unit sphere.
double ShareOfTheSphere(const std::string& camera, const std::string& place) {
  const auto scene = testing_support::CompileText(
      "Camera { center 0 0 0 direction 0 0 -1 up 0 1 0 " + camera +
      " }\nMaterials { Material { diffuse 1 1 1 } }\n"
      "Scene { Transform { translate " +
      place + " } Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }");
  RenderOptions options;
  options.grid = PixelGrid::kCentres;
  const std::vector<FirstHit> hits = RenderFirstHits(*scene, options);
  const auto count =
      std::count_if(hits.begin(), hits.end(), [](const FirstHit& hit) { return hit.is_hit; });
  return static_cast<double>(count) / 640000;
}

// P14: with parallel rays it is as large at any distance: pi / h^2.
TEST(Silhouette, OfParallelRaysDoesNotDependOnTheDistance) {
  const double share = M_PI / 16;
  EXPECT_NEAR(ShareOfTheSphere("type orthographic height 4", "0 0 -3"), share, 1e-3 * share);
  EXPECT_NEAR(ShareOfTheSphere("type orthographic height 4", "0.5 -0.25 -700"), share,
              1e-3 * share);
}

// P14: the rim of a sphere of radius 1 at the distance 2 is 30 degrees off its middle.
TEST(Silhouette, OfAFisheyeIsADiskOfItsAngle) {
  // A third of the radius of a fisheye of 180 degrees.
  const double share = M_PI / 4 / 9;
  EXPECT_NEAR(ShareOfTheSphere("type fisheye", "0 0 -2"), share, 1e-3 * share);
  const double sine = std::sin(M_PI / 12);
  const double even = M_PI / 4 * sine * sine;
  const std::string all_around = "type fisheye mapping equisolid fov 360";
  EXPECT_NEAR(ShareOfTheSphere(all_around, "0 0 -2"), even, 1e-3 * even);
  EXPECT_NEAR(ShareOfTheSphere(all_around, "1.2 -1.6 0"), even, 2e-3 * even);
  EXPECT_NEAR(ShareOfTheSphere(all_around, "1.2 0 1.6"), even, 2e-3 * even);
}

// P14: a cap of 30 degrees around a pole is a sixth of all latitudes, whatever the longitude. In a
// square picture there is half of the longitudes.
TEST(Silhouette, OfAPanoramaIsABandAroundAPole) {
  EXPECT_NEAR(ShareOfTheSphere("type panoramic", "0 2 0"), 1.0 / 6, 1.5e-3);
  EXPECT_NEAR(ShareOfTheSphere("type panoramic", "0 -2 0"), 1.0 / 6, 1.5e-3);
  EXPECT_EQ(ShareOfTheSphere("type panoramic", "0 0 4"), 0);
}

// P14, CF24
TEST(Silhouette, WithPixelCentresCoversItsShareOfTheArea) {
  EXPECT_NEAR(PixelsOfTheSphere(PixelGrid::kCentres), 70718, 70.7);
}

// P14, CF24: with corners on -1 and 1 the picture is 799 pixels wide.
TEST(Silhouette, WithTheCoursesMappingCoversItsShareOfTheArea) {
  EXPECT_NEAR(PixelsOfTheSphere(PixelGrid::kCorners), 70541, 70.5);
}

}  // namespace
}  // namespace candela
