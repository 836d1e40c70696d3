#include "image/bloom.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.h"

namespace candela {
namespace {

/// Black but for one pixel.
Image Dot(int width, int height, int x, int y, float value = 1) {
  Image picture(width, height, 3);
  for (int c = 0; c < 3; ++c) picture.At(x, y, c) = value * static_cast<float>(c + 1);
  return picture;
}

double SumOf(const Image& picture, int c) {
  double sum = 0;
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) sum += static_cast<double>(picture.At(x, y, c));
  }
  return sum;
}

TEST(AddBloom, KeepsAllLightThatStaysInThePicture) {
  for (const float radius : {0.0f, 0.4f, 1.0f, 7.5f, 30.0f}) {
    for (const float strength : {0.1f, 1.0f}) {
      Image picture = Dot(81, 67, 40, 33, 1000);
      AddBloom({strength, radius}, &picture);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(SumOf(picture, c), 1000 * (c + 1), 1e-3) << radius;
    }
  }
}

// Beyond the edge the light is lost: in the corner, with nearly all of it spread, three quarters
// of the half of it that does not fall on the two lines through the dot, and halves of these.
TEST(AddBloom, LosesWhatLeavesThePicture) {
  Image inside = Dot(121, 121, 60, 60), corner = Dot(61, 61, 0, 0);
  AddBloom({1, 30}, &inside);
  AddBloom({1, 30}, &corner);
  for (int y = 0; y < 61; ++y) {
    for (int x = 0; x < 61; ++x) EXPECT_EQ(corner.At(x, y, 0), inside.At(60 + x, 60 + y, 0));
  }
  EXPECT_GT(SumOf(corner, 0), 0.25);
  EXPECT_LT(SumOf(corner, 0), 0.5);
}

TEST(AddBloom, AnswersADotSymmetrically) {
  Image picture = Dot(61, 61, 30, 30);
  AddBloom({0.5f, 24}, &picture);
  for (int y = 0; y <= 60; ++y) {
    for (int x = 0; x <= 60; ++x) {
      EXPECT_EQ(picture.At(x, y, 0), picture.At(60 - x, y, 0));
      EXPECT_EQ(picture.At(x, y, 0), picture.At(x, 60 - y, 0));
      EXPECT_NEAR(picture.At(x, y, 0), picture.At(y, x, 0), 1e-8);
      EXPECT_NEAR(picture.At(x, y, 2), 3 * picture.At(x, y, 0), 1e-7);
    }
  }
  // It fades with the distance, and ends where it says.
  for (int x = 31; x <= 54; ++x) EXPECT_LT(picture.At(x, 30, 0), picture.At(x - 1, 30, 0));
  EXPECT_GT(picture.At(54, 30, 0), 0);
  EXPECT_EQ(picture.At(55, 30, 0), 0);
  EXPECT_EQ(picture.At(30, 5, 0), 0);
}

// The variance is the mean of those of three normal distributions that are cut off at three
// deviations, which leaves 0.97334 of it: (30^2 + 10^2 + (10/3)^2) / 3 of that.
TEST(AddBloom, IsAsWideAsItSays) {
  Image picture = Dot(201, 201, 100, 100);
  AddBloom({1, 90}, &picture);
  double along = 0, across = 0;
  for (int y = 0; y < 201; ++y) {
    for (int x = 0; x < 201; ++x) {
      along += static_cast<double>(picture.At(x, y, 0)) * (x - 100) * (x - 100);
      across += static_cast<double>(picture.At(x, y, 0)) * (y - 100) * (y - 100);
    }
  }
  EXPECT_NEAR(along, 328.05, 3);
  EXPECT_NEAR(across, along, 1e-3);
}

TEST(AddBloom, LeavesEvenLightAsItIsFarFromTheEdges) {
  Image picture(64, 48, 3, 0.7f);
  AddBloom({0.8f, 9}, &picture);
  for (int y = 9; y < 48 - 9; ++y) {
    for (int x = 9; x < 64 - 9; ++x) EXPECT_NEAR(picture.At(x, y, 1), 0.7, 1e-6);
  }
  EXPECT_LT(picture.At(0, 0, 1), 0.6f);
}

TEST(AddBloom, OfNoStrengthOrReachChangesNothing) {
  Image picture = Dot(33, 21, 7, 9, 0.3f);
  picture.At(3, 4, 1) = -2;  // The course knows lights that take away.
  const Image before = picture;
  AddBloom({0, 10}, &picture);
  EXPECT_EQ(picture, before);
  AddBloom({1, 0}, &picture);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.At(7, 9, c), before.At(7, 9, c), 1e-6);
  EXPECT_EQ(picture.At(8, 9, 0), 0);
  Image empty(0, 0, 3);
  AddBloom({0.5f, 10}, &empty);
}

TEST(AddBloom, WorksBeyondThePictureAndOnALine) {
  Image picture = Dot(5, 1, 2, 0);
  AddBloom({1, 1000}, &picture);
  for (int x = 0; x < 5; ++x) EXPECT_GT(picture.At(x, 0, 0), 0);
  EXPECT_EQ(picture.At(0, 0, 0), picture.At(4, 0, 0));
}

TEST(AddBloom, GivesTheSameBitsForAnyNumberOfThreads) {
  Image picture(97, 55, 3);
  float value = 0.1f;
  for (float& sample : picture.Samples()) {
    value = value * 3.7f - std::floor(value * 3.7f);
    sample = value * value * 10;
  }
  Image alone = picture, together = picture;
  {
    const ThreadLimit limit(1);
    AddBloom({0.3f, 20}, &alone);
  }
  {
    const ThreadLimit limit(5);
    AddBloom({0.3f, 20}, &together);
  }
  EXPECT_EQ(alone, together);
  EXPECT_NE(alone, picture);
}

}  // namespace
}  // namespace candela
