#include "textures/mip_map.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

/// 4 x 4 texels whose red is the column, whose green is the row from below, and whose blue is 1.
Image Ramp() {
  Image image(4, 4, 3, 1);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      image.At(x, y, 0) = static_cast<float>(x);
      image.At(x, y, 1) = static_cast<float>(3 - y);
    }
  }
  return image;
}

TEST(MipMap, TexelsHaveTheirValuesAtTheirCentres) {
  const MipMap map(Ramp(), Wrap::kRepeat);
  EXPECT_EQ(map.Lookup({0.125f, 0.125f}, 0), (Rgb{0, 0, 1}));
  EXPECT_EQ(map.Lookup({0.875f, 0.625f}, 0), (Rgb{3, 2, 1}));
}

TEST(MipMap, IsLinearBetweenCentres) {
  const MipMap map(Ramp(), Wrap::kRepeat);
  EXPECT_EQ(map.Lookup({0.5f, 0.25f}, 0), (Rgb{1.5f, 0.5f, 1}));
  EXPECT_EQ(map.Lookup({0.4375f, 0.125f}, 0), (Rgb{1.25f, 0, 1}));
}

// At the left edge the first texel meets the last one, itself, or nothing new.
TEST(MipMap, GoesOnBeyondItsEdges) {
  EXPECT_EQ(MipMap(Ramp(), Wrap::kRepeat).Lookup({0, 0.125f}, 0).x, 1.5f);
  EXPECT_EQ(MipMap(Ramp(), Wrap::kMirror).Lookup({0, 0.125f}, 0).x, 0);
  EXPECT_EQ(MipMap(Ramp(), Wrap::kClamp).Lookup({0, 0.125f}, 0).x, 0);
  EXPECT_EQ(MipMap(Ramp(), Wrap::kRepeat).Lookup({-0.625f, 7.125f}, 0), (Rgb{1, 0, 1}));
  EXPECT_EQ(MipMap(Ramp(), Wrap::kMirror).Lookup({1.125f, -0.125f}, 0), (Rgb{3, 0, 1}));
  EXPECT_EQ(MipMap(Ramp(), Wrap::kClamp).Lookup({9, -9}, 0), (Rgb{3, 0, 1}));
}

TEST(MipMap, WideLookupsAreMeans) {
  const MipMap map(Ramp(), Wrap::kClamp);
  ASSERT_EQ(map.LevelCount(), 3);
  // Two texels wide: the means of four.
  EXPECT_EQ(map.Lookup({0.25f, 0.25f}, 0.5f), (Rgb{0.5f, 0.5f, 1}));
  // The whole picture, and more.
  EXPECT_EQ(map.Lookup({0.9f, 0.1f}, 1), (Rgb{1.5f, 1.5f, 1}));
  EXPECT_EQ(map.Lookup({0.9f, 0.1f}, 100), (Rgb{1.5f, 1.5f, 1}));
  // Between the levels half of each.
  const float width = 0.25f * 1.41421356f;
  EXPECT_NEAR(map.Lookup({0.125f, 0.125f}, width).x, 0.5f * (0 + 0.5f), 1e-6);
}

TEST(MipMap, KeepsTheMeanOfOddSizes) {
  Image image(3, 1, 3, 1);
  image.At(0, 0, 0) = 7;
  const MipMap map(std::move(image), Wrap::kRepeat);
  EXPECT_EQ(map.LevelCount(), 2);
  EXPECT_EQ(map.Lookup({0.5f, 0.5f}, 1).x, 3);
}

// Columns times columns are beyond 32 bits. The right half of the picture, or its lower one,
// shines.
TEST(MipMap, TakesLongStrips) {
  constexpr int kLength = 65540;
  Image wide(kLength, 1, 3), high(1, kLength, 3);
  for (int i = kLength / 2; i < kLength; ++i) wide.At(i, 0, 0) = high.At(0, i, 0) = 1;
  const MipMap columns(std::move(wide), Wrap::kClamp), rows(std::move(high), Wrap::kClamp);
  EXPECT_EQ(columns.LevelCount(), 17);
  EXPECT_EQ(rows.LevelCount(), 17);
  EXPECT_NEAR(columns.Lookup({0.5f, 0.5f}, 1).x, 0.5f, 1e-4f);
  EXPECT_NEAR(rows.Lookup({0.5f, 0.5f}, 1).x, 0.5f, 1e-4f);
  EXPECT_EQ(columns.Lookup({0.99f, 0.5f}, 1e-4f).x, 1);
  EXPECT_EQ(rows.Lookup({0.5f, 0.01f}, 1e-4f).x, 1);
}

TEST(MipMap, IsFiniteEverywhere) {
  constexpr float kOdd[] = {0,
                            1,
                            -1,
                            1e-38f,
                            1e10f,
                            -3e38f,
                            std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()};
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp}) {
    const MipMap map(Ramp(), wrap);
    for (const float u : kOdd) {
      for (const float v : kOdd) {
        for (const float width : kOdd) EXPECT_TRUE(IsFinite(map.Lookup({u, v}, width)));
      }
    }
  }
}

}  // namespace
}  // namespace candela
