#include "math/frame.h"

#include <gtest/gtest.h>

#include <random>

namespace candela {
namespace {

void ExpectOrthonormal(const Frame& frame) {
  constexpr float kTolerance = 3e-7f;
  EXPECT_NEAR(Length(frame.x), 1, kTolerance);
  EXPECT_NEAR(Length(frame.y), 1, kTolerance);
  EXPECT_NEAR(Dot(frame.x, frame.y), 0, kTolerance);
  EXPECT_NEAR(Dot(frame.x, frame.z), 0, kTolerance);
  EXPECT_NEAR(Dot(frame.y, frame.z), 0, kTolerance);
  EXPECT_GT(Dot(Cross(frame.x, frame.y), frame.z), 0.999f) << "not right-handed";
}

TEST(Frame, IsOrthonormalAroundAnyNormal) {
  std::mt19937 bits(1);
  const auto coordinate = [&] { return static_cast<float>(static_cast<int32_t>(bits())); };
  for (int i = 0; i < 10000; ++i) {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    ExpectOrthonormal(Frame::FromNormal(Normalize(Vec3{x, y, z})));
  }
}

// Where the formula without the sign divides by zero, or by almost zero.
TEST(Frame, IsOrthonormalAroundTheLowerPole) {
  ExpectOrthonormal(Frame::FromNormal({0, 0, -1}));
  ExpectOrthonormal(Frame::FromNormal({0, 0, 1}));
  for (const float tilt : {1e-7f, 1e-5f, 1e-4f, 1e-3f}) {
    ExpectOrthonormal(Frame::FromNormal(Normalize(Vec3{tilt, -tilt, -1})));
  }
  ExpectOrthonormal(Frame::FromNormal({1, 0, -0.0f}));
}

TEST(Frame, LocalZIsTheNormal) {
  const Vec3 n = Normalize(Vec3{1, -2, 3});
  const Frame frame = Frame::FromNormal(n);
  EXPECT_EQ(frame.ToWorld({0, 0, 1}), n);
  EXPECT_NEAR(frame.ToLocal(n).z, 1, 1e-6f);
}

TEST(Frame, GoesThereAndBack) {
  const Frame frame = Frame::FromNormal(Normalize(Vec3{-0.3f, 0.5f, -0.9f}));
  const Vec3 v{0.25f, -1.5f, 4};
  EXPECT_LT(Length(frame.ToLocal(frame.ToWorld(v)) - v), 1e-6f);
  EXPECT_LT(Length(frame.ToWorld(frame.ToLocal(v)) - v), 1e-6f);
}

}  // namespace
}  // namespace candela
