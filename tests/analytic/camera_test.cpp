// How large a sphere looks: its rim lies asin(r / d) off the line to its centre.

#include <gtest/gtest.h>

#include <algorithm>

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
