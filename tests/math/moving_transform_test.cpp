// Ways into spaces that move: what `MatrixAt` takes out they take back.

#include "math/moving_transform.h"

#include <gtest/gtest.h>

#include <vector>

namespace candela {
namespace {

constexpr float kTimes[] = {0, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 1};

void ExpectInverse(const std::vector<Mat4>& steps) {
  const MovingInverse inverse(steps);
  const MovingTransform both(steps);
  for (const float time : kTimes) {
    SCOPED_TRACE(time);
    const auto back = inverse.At(time);
    const auto pair = both.At(time);
    ASSERT_TRUE(back && pair);
    const Transform out(MatrixAt(steps, time)), inverted(*InverseAffine(MatrixAt(steps, time)));
    for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1, -2, 0.5f}, Vec3{-3, 0.25f, 4}}) {
      const Vec3 there = out.Point(p);
      EXPECT_EQ(pair->world_from_object.Point(p), there);
      EXPECT_EQ(pair->object_from_world.Point(there), back->Point(there));
      EXPECT_LT(Length(back->Point(there) - p), 3e-6f);
      EXPECT_LT(Length(back->Vector(out.Vector(p)) - p), 3e-6f);
      EXPECT_LT(Length(back->Point(there) - inverted.Point(there)), 1e-6f);
    }
  }
}

// The quick way, which has an offset for each step, is taken where it can be.
TEST(MovingInverse, KeepsOffsetsOfWhatIsOnlyMoved) {
  const Mat4 moved = Mat4::Translate({1, 2, 3}), turned = Mat4::Rotate(1, 40);
  const uint64_t with_offsets = MovingInverse({turned, moved * turned}).MemoryBytes();
  const uint64_t without = MovingInverse({Mat4::Identity(), turned}).MemoryBytes();
  EXPECT_EQ(without, 2 * sizeof(Mat4));
  EXPECT_GE(with_offsets, without + 2 * sizeof(Vec3d));
}

TEST(MovingInverse, LeadsBackFromWhatIsOnlyMoved) {
  const Mat4 turned = Mat4::Rotate(0, 30) * Mat4::Rotate(2, -50) * Mat4::Scale({0.5, 2, -1});
  for (const Mat4& linear : {Mat4::Identity(), turned}) {
    ExpectInverse({linear, Mat4::Translate({1, 2, 3}) * linear});
    ExpectInverse({Mat4::Translate({-1, 0, 2}) * linear, linear,
                   Mat4::Translate({4, 1, 0}) * linear, Mat4::Translate({0, 0, -1}) * linear});
  }
}

TEST(MovingInverse, LeadsBackFromWhatTurnsAndGrows) {
  ExpectInverse({Mat4::Identity(), Mat4::Rotate(1, 40)});
  ExpectInverse({Mat4::Scale({1, 1, 1}), Mat4::Translate({0, 1, 0}) * Mat4::Scale({2, 3, 1}),
                 Mat4::Scale({0.5, 0.5, 0.5})});
}

TEST(MovingInverse, IsNoneWhereAllIsInOnePlane) {
  const std::vector<Mat4> mirrored = {Mat4::Identity(), Mat4::Scale({-1, 1, 1})};
  EXPECT_FALSE(MovingInverse(mirrored).At(0.5f));
  EXPECT_FALSE(MovingTransform(mirrored).At(0.5f));
  EXPECT_TRUE(MovingInverse(mirrored).At(0.25f));
  const Mat4 flat = Mat4::Scale({1, 0, 1});
  for (const float time : kTimes) {
    EXPECT_FALSE(MovingInverse({flat, Mat4::Translate({1, 0, 0}) * flat}).At(time));
  }
}

TEST(MovingTransform, AtRestIsTheSameAtAllTimes) {
  const MovingTransform space({Mat4::Translate({1, 2, 3})});
  EXPECT_TRUE(space.IsAtRest());
  for (const float time : kTimes) {
    EXPECT_EQ(space.At(time)->object_from_world.Point({1, 2, 3}), (Vec3{0, 0, 0}));
  }
}

}  // namespace
}  // namespace candela
