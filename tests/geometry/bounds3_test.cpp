#include "geometry/bounds3.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

const Bounds3 kUnitCube = {{0, 0, 0}, {1, 1, 1}};

TEST(Bounds3, TheDefaultContainsNothingAndHasNoArea) {
  EXPECT_TRUE(Bounds3().IsEmpty());
  EXPECT_FALSE(Bounds3().Contains({0, 0, 0}));
  EXPECT_EQ(Bounds3().HalfArea(), 0.0);
}

TEST(Bounds3, APointIsABoxWithoutArea) {
  Bounds3 box;
  box.Extend(Vec3{1, 2, 3});
  EXPECT_FALSE(box.IsEmpty());
  EXPECT_TRUE(box.Contains({1, 2, 3}));
  EXPECT_EQ(box.HalfArea(), 0.0);
}

TEST(Bounds3, HalfAreaIsThatOfThreeFaces) {
  EXPECT_EQ((Bounds3{{0, 0, 0}, {1, 2, 3}}.HalfArea()), 11.0);
}

// In single precision the first would be 0 and the second infinite.
TEST(Bounds3, HalfAreaOfTinyAndHugeBoxesKeepsItsValue) {
  EXPECT_GT((Bounds3{{0, 0, 0}, {1e-30f, 1e-30f, 1e-30f}}.HalfArea()), 2.9e-60);
  EXPECT_LT((Bounds3{{-3e38f, -3e38f, -3e38f}, {3e38f, 3e38f, 3e38f}}.HalfArea()), 1.1e78);
}

TEST(TransformBounds, ContainsTheImageOfEachCorner) {
  const Transform turn(Mat4::Translate({100, -7, 3}) * Mat4::Rotate(2, 45) * Mat4::Rotate(0, 30));
  const Bounds3 image = TransformBounds(turn, kUnitCube);
  for (const float x : {0.0f, 1.0f}) {
    for (const float y : {0.0f, 1.0f}) {
      for (const float z : {0.0f, 1.0f}) EXPECT_TRUE(image.Contains(turn.Point({x, y, z})));
    }
  }
  EXPECT_LT(image.Extent().x, 1.42f + 0.61f);  // cos 45 + sin 45 cos 30
}

TEST(TransformBounds, AMirrorGivesAnOrderedBox) {
  const Bounds3 image = TransformBounds(Transform(Mat4::Scale({-2, 1, 1})), kUnitCube);
  EXPECT_NEAR(image.min.x, -2, 1e-5);
  EXPECT_NEAR(image.max.x, 0, 1e-5);
}

TEST(TransformBounds, EmptyStaysEmptyAndUnboundedStaysUnbounded) {
  const Transform move(Mat4::Translate({1, 2, 3}));
  EXPECT_TRUE(TransformBounds(move, Bounds3()).IsEmpty());
  EXPECT_EQ(TransformBounds(move, Bounds3::Infinite()), Bounds3::Infinite());
}

// 1e30 * 1e30 - 1e30 * 1e30 is not a number in single precision: the image must not look empty.
TEST(TransformBounds, AnImageTooLargeForSinglePrecisionIsUnbounded) {
  Mat4 shear = Mat4::Scale({1e30, 1, 1});
  shear.m[0][1] = -1e30;
  const Bounds3 point = {{1e30f, 1e30f, 0}, {1e30f, 1e30f, 0}};
  EXPECT_EQ(TransformBounds(Transform(shear), point), Bounds3::Infinite());
}

}  // namespace
}  // namespace candela
