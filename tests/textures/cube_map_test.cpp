#include "textures/cube_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "image/png_write.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_support::Put;
using testing_support::TempFolder;

const std::string kNames[] = {"left", "right", "up", "down", "front", "back"};

/// A face of 4 x 4 texels whose red is 10 times the column, green 10 times the row, and blue the
/// number of the face: a lookup at (X, Y) in texels gives 10 X, 10 Y until the last texel's centre.
ByteImage Ramp(size_t face) {
  ByteImage image(4, 4, 3);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      image.At(x, y, 0) = static_cast<uint8_t>(10 * x);
      image.At(x, y, 1) = static_cast<uint8_t>(10 * y);
      image.At(x, y, 2) = static_cast<uint8_t>(face);
    }
  }
  return image;
}

class CubeMapTest : public testing::Test {
 protected:
  CubeMapTest() {
    for (size_t face = 0; face < 6; ++face) PutFace(kNames[face], Ramp(face));
  }

  template <class T>
  void PutFace(const std::string& name, const Raster<T>& image) {
    Put(folder_ / (name + ".png"), EncodePng(image).value());
  }

  std::optional<CubeMap> Load() { return CubeMap::Load(folder_.path(), {}, &diagnostics_); }

  /// Looks up in levels of 1/255.
  void ExpectLevels(Vec3 direction, Rgb expected) {
    const auto map = Load();
    ASSERT_THAT(diagnostics_.Lines(), IsEmpty());
    const Rgb levels = map->Lookup(direction) * 255;
    EXPECT_NEAR(levels.x, expected.x, 1e-4);
    EXPECT_NEAR(levels.y, expected.y, 1e-4);
    EXPECT_NEAR(levels.z, expected.z, 1e-4);
  }

  TempFolder folder_;
  Diagnostics diagnostics_;
};

// The table of the course, at a quarter or three quarters of the width and 5/8 of the height
// (counted upwards): X = 4 u, Y = 4 (1 - v).
TEST_F(CubeMapTest, RightIsTowardsX) {
  ExpectLevels({1, 0.25f, -0.5f}, {10, 15, 1});
}
TEST_F(CubeMapTest, LeftIsTowardsMinusX) {
  ExpectLevels({-1, 0.25f, -0.5f}, {30, 15, 0});
}
TEST_F(CubeMapTest, UpIsTowardsY) {
  ExpectLevels({-0.5f, 1, 0.25f}, {10, 15, 2});
}
TEST_F(CubeMapTest, DownIsTowardsMinusYAndUpsideDown) {
  ExpectLevels({-0.5f, -1, 0.25f}, {10, 15, 3});
}
TEST_F(CubeMapTest, FrontIsTowardsZ) {
  ExpectLevels({-0.5f, 0.25f, 1}, {30, 15, 4});
}
TEST_F(CubeMapTest, BackIsTowardsMinusZAndMirrored) {
  ExpectLevels({-0.5f, 0.25f, -1}, {30, 15, 5});
}

TEST_F(CubeMapTest, TheLengthOfTheDirectionDoesNotMatter) {
  ExpectLevels({4, 1, -2}, {10, 15, 1});
  ExpectLevels({-0.5e-30f, 0.25e-30f, -1e-30f}, {30, 15, 5});
}

TEST_F(CubeMapTest, OnTiesXComesBeforeYBeforeZ) {
  ExpectLevels({1, 1, 1}, {30, 0, 1});
  ExpectLevels({-1, 1, 1}, {0, 0, 0});
  ExpectLevels({0, 1, 1}, {20, 0, 2});
  ExpectLevels({0, -1, -1}, {20, 30, 3});
}

// The middle of a face is the corner of four texels, but without a shift by half a texel it is the
// texel (2, 2) alone.
TEST_F(CubeMapTest, ThereIsNoShiftByHalfATexel) {
  ExpectLevels({0, 0, 1}, {20, 20, 4});
}

TEST_F(CubeMapTest, FourTexelsAreBlendedByTheFractions) {
  ByteImage face(2, 2, 1);
  face.At(0, 0) = 0, face.At(1, 0) = 16, face.At(0, 1) = 64, face.At(1, 1) = 255;
  PutFace("right", face);
  // X = 0.5, Y = 0.25: 3/4 of the mean of the upper two and 1/4 of that of the lower two.
  const float expected = 0.75f * 8 + 0.25f * 159.5f;
  ExpectLevels({1, 0.75f, -0.5f}, {expected, expected, expected});
}

TEST_F(CubeMapTest, AtTheBordersTheLastTexelsAreRepeated) {
  ExpectLevels({1, -0.999f, 0.999f}, {30, 30, 1});
  ExpectLevels({1, 1, -1}, {0, 0, 1});
}

TEST_F(CubeMapTest, AFaceOfOneTexelHasOneColour) {
  ByteImage face(1, 1, 3);
  face.At(0, 0, 0) = 51, face.At(0, 0, 1) = 102, face.At(0, 0, 2) = 255;
  PutFace("right", face);
  for (const float y : {-1.0f, -0.3f, 0.0f, 0.9f, 1.0f}) ExpectLevels({1, y, -y}, {51, 102, 255});
}

TEST_F(CubeMapTest, GreyStandsForAllThreeChannels) {
  PutFace("right", ByteImage(2, 2, 1, uint8_t{40}));
  ExpectLevels({1, 0, 0}, {40, 40, 40});
  PutFace("right", ByteImage(2, 2, 2, uint8_t{50}));
  ExpectLevels({1, 0, 0}, {50, 50, 50});
}

TEST_F(CubeMapTest, AlphaIsNotUsed) {
  ByteImage face(1, 1, 4);
  face.At(0, 0, 0) = 1, face.At(0, 0, 1) = 2, face.At(0, 0, 2) = 3, face.At(0, 0, 3) = 0;
  PutFace("right", face);
  ExpectLevels({1, 0, 0}, {1, 2, 3});
}

TEST_F(CubeMapTest, SixteenBitsKeepTheirPrecision) {
  PutFace("right", WordImage(1, 1, 3, uint16_t{257 * 40 + 64}));  // 40 and a quarter of a level.
  const float level = 40 + 64.0f / 257;
  ExpectLevels({1, 0, 0}, {level, level, level});
}

TEST_F(CubeMapTest, FacesMayDifferInSizeAndNeedNotBeSquare) {
  PutFace("right", ByteImage(7, 2, 3, uint8_t{9}));
  ExpectLevels({1, 0.3f, 0.4f}, {9, 9, 9});
  ExpectLevels({0, 0, 1}, {20, 20, 4});
}

TEST_F(CubeMapTest, WhiteIsOne) {
  PutFace("right", ByteImage(3, 3, 3, uint8_t{255}));
  const auto map = Load();
  for (const float y : {-1.0f, -0.37f, 0.11f, 0.7f}) {
    EXPECT_NEAR(map->Lookup({1, y, 0.2f}).x, 1, 2e-7);
  }
}

TEST_F(CubeMapTest, MissingFacesAreNamedInTheirOrder) {
  std::filesystem::remove(folder_ / "up.png");
  std::filesystem::remove(folder_ / "back.png");
  EXPECT_FALSE(Load());
  EXPECT_THAT(diagnostics_.Lines(), ElementsAre(HasSubstr("up.png"), HasSubstr("back.png")));
}

TEST_F(CubeMapTest, ABrokenFaceIsReportedUnderItsOwnName) {
  Put(folder_ / "down.png", "this is not a picture");
  EXPECT_FALSE(Load());
  EXPECT_THAT(diagnostics_.Lines(), ElementsAre(HasSubstr("down.png: error: ")));
}

TEST_F(CubeMapTest, MemoryIsThatOfTheTexels) {
  EXPECT_EQ(Load()->MemoryBytes(), 6u * 4 * 4 * 3);
}

}  // namespace
}  // namespace candela
