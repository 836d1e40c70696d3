// A pinhole shows straight lines straight, wherever in the picture they are.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/elementary.h"
#include "tests/optics/bright_scene.h"

namespace candela {
namespace {

constexpr int kSize = 128;

/// Where the right edge of what shines lies in each row, in pixels from the left of the picture.
std::vector<double> EdgeByRow(const Image& image) {
  std::vector<double> edges;
  for (int y = 0; y < image.Height(); ++y) {
    double sum = 0;
    for (int x = 0; x < image.Width(); ++x) sum += static_cast<double>(image.At(x, y));
    edges.push_back(sum);
  }
  return edges;
}

// P14. The edge goes from near to far away, so that its own distance changes fourfold.
TEST(Pinhole, ShowsTheEdgeOfALeaningPlaneAsAStraightLineInItsPlace) {
  for (const double fov : {20.0, 60.0, 110.0}) {
    const double reach = TanDegrees(fov / 2);
    // From the lower edge of the picture at a distance of 1 to the upper one at a distance of 4,
    // and on in both directions; all that is left of it shines.
    const Vec3d low{0.35 * reach, -reach, -1}, high{2.8 * reach, 4 * reach, -4};
    const Vec3d along = (high - low) * 0.2;
    const auto corner = [](const char* name, Vec3d p) {
      return fmt::format(" {} {:.9g} {:.9g} {:.9g}", name, p.x, p.y, p.z);
    };
    const Vec3d from = low - along, to = high + along, far_left{-60 * reach, to.y, to.z};
    const Vec3d near_left{-60 * reach, from.y, from.z};
    const std::string nodes =
        test::Shining("", "triangle" + corner("vertex0", from) + corner("vertex1", to) +
                              corner("vertex2", far_left)) +
        test::Shining("", "triangle" + corner("vertex0", from) + corner("vertex1", far_left) +
                              corner("vertex2", near_left));
    const auto scene = test::SceneOf(nodes, fov);
    const auto edges = EdgeByRow(test::Seen(*scene, test::Picture(kSize, kSize, "box", 128)));
    for (int y = 1; y + 1 < kSize; ++y) {
      // The middle of the row between -1, below, and 1; at -1 the edge is at 0.35, at 1 at 0.7.
      const double height = 1 - 2 * (y + 0.5) / kSize;
      const double expected = (1 + 0.35 + (height + 1) / 2 * 0.35) / 2 * kSize;
      EXPECT_NEAR(edges[static_cast<size_t>(y)], expected, 0.05) << fov << ", row " << y;
    }
  }
}

}  // namespace
}  // namespace candela
