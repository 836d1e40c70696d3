#include "cameras/image_plane.h"

#include <gtest/gtest.h>

#include <utility>

namespace candela {
namespace {

TEST(ImagePlane, CornerPixelsLieExactlyOnTheEdges) {
  for (const int size : {2, 3, 200, 799, 800, 16384}) {
    const ImagePlane plane(size, size, PixelGrid::kCorners, false);
    EXPECT_EQ(plane.PointOf(0, 0, {}), (Vec2{-1, 1})) << size;
    EXPECT_EQ(plane.PointOf(size - 1, 0, {}), (Vec2{1, 1})) << size;
    EXPECT_EQ(plane.PointOf(0, size - 1, {}), (Vec2{-1, -1})) << size;
    EXPECT_EQ(plane.PointOf(size - 1, size - 1, {}), (Vec2{1, -1})) << size;
  }
}

// The formulas of the course, x = 2 i / (W - 1) - 1 and y = 2 j / (H - 1) - 1 with j counted from
// the bottom, to the last bit.
TEST(ImagePlane, EveryPixelIsWhereTheCoursePutsIt) {
  const ImagePlane plane(800, 800, PixelGrid::kCorners, false);
  for (int i = 0; i < 800; ++i) {
    const float expected = 2.0f * static_cast<float>(i) / 799.0f - 1.0f;
    EXPECT_EQ(plane.PointOf(i, 0, {}).x, expected);
    EXPECT_EQ(plane.PointOf(0, 799 - i, {}).y, expected);
  }
}

TEST(ImagePlane, ASideOfOnePixelMapsToZero) {
  for (const PixelGrid grid : {PixelGrid::kCorners, PixelGrid::kCentres}) {
    EXPECT_EQ(ImagePlane(1, 1, grid, false).PointOf(0, 0, {}), (Vec2{0, 0}));
    EXPECT_EQ(ImagePlane(1, 5, grid, false).PointOf(0, 2, {}), (Vec2{0, 0}));
    EXPECT_EQ(ImagePlane(5, 1, grid, false).PointOf(2, 0, {}), (Vec2{0, 0}));
  }
}

TEST(ImagePlane, PositionsAreTheInverseOfPoints) {
  for (const PixelGrid grid : {PixelGrid::kCorners, PixelGrid::kCentres}) {
    for (const bool stretch : {false, true}) {
      for (const auto& [width, height] : {std::pair(40, 30), std::pair(7, 200), std::pair(1, 5)}) {
        const ImagePlane plane(width, height, grid, stretch);
        for (const Vec2 offset : {Vec2{0, 0}, Vec2{0.25f, -0.5f}, Vec2{-0.5f, 0.375f}}) {
          const Vec2 position = plane.PositionOf(plane.PointOf(width / 2, height / 3, offset));
          EXPECT_NEAR(position.x, static_cast<float>(width / 2) + offset.x, 2e-5);
          EXPECT_NEAR(position.y, static_cast<float>(height / 3) + offset.y, 2e-5);
        }
        // The area between the centres of four pixels.
        const Vec2 a = plane.PointOf(0, 0, {}), b = plane.PointOf(0, 0, {1, 1});
        EXPECT_NEAR((b.x - a.x) * (a.y - b.y) * plane.PixelsPerArea(), 1, 1e-5);
      }
    }
  }
}

TEST(ImagePlane, CentresLieHalfAPixelInside) {
  const ImagePlane plane(4, 4, PixelGrid::kCentres, false);
  EXPECT_EQ(plane.PointOf(0, 0, {}), (Vec2{-0.75f, 0.75f}));
  EXPECT_EQ(plane.PointOf(3, 3, {}), (Vec2{0.75f, -0.75f}));
  EXPECT_EQ(plane.PointOf(0, 0, {-0.5f, -0.5f}), (Vec2{-1, 1}));
}

TEST(ImagePlane, OffsetsCountInPixelsAndDownwards) {
  const ImagePlane corners(5, 5, PixelGrid::kCorners, false);
  EXPECT_EQ(corners.PointOf(2, 2, {0.5f, 0}), (Vec2{0.25f, 0}));
  EXPECT_EQ(corners.PointOf(2, 2, {0, 0.5f}), (Vec2{0, -0.25f}));
  EXPECT_EQ(corners.PointOf(2, 2, {1, 1}), corners.PointOf(3, 3, {}));
}

// The field of view is the vertical one; a picture twice as wide sees twice as far to the sides.
TEST(ImagePlane, PixelsAreSquareWhateverThePictureIs) {
  const ImagePlane wide(8, 4, PixelGrid::kCentres, false);
  EXPECT_EQ(wide.PointOf(0, 0, {-0.5f, -0.5f}), (Vec2{-2, 1}));
  const ImagePlane tall(5, 9, PixelGrid::kCorners, false);
  EXPECT_EQ(tall.PointOf(0, 0, {}), (Vec2{-0.5f, 1}));
  EXPECT_EQ(tall.PointOf(3, 4, {}).x, tall.PointOf(2, 3, {}).y);
}

TEST(ImagePlane, StretchedTheFieldOfViewFillsBothSides) {
  const ImagePlane plane(9, 5, PixelGrid::kCorners, true);
  EXPECT_EQ(plane.PointOf(0, 0, {}), (Vec2{-1, 1}));
  EXPECT_EQ(plane.PointOf(8, 4, {}), (Vec2{1, -1}));
}

TEST(ImagePlane, StretchingASquareChangesNothing) {
  for (const PixelGrid grid : {PixelGrid::kCorners, PixelGrid::kCentres}) {
    const ImagePlane plain(7, 7, grid, false), stretched(7, 7, grid, true);
    for (int i = 0; i < 7; ++i) {
      EXPECT_EQ(plain.PointOf(i, i, {0.3f, 0.2f}), stretched.PointOf(i, i, {0.3f, 0.2f}));
    }
  }
}

}  // namespace
}  // namespace candela
