#include "image/compare.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CompareImages, EqualPicturesHaveInfinitePsnr) {
  const ByteImage image(4, 4, 3, 77);
  const Result<ImageDifference> result = CompareImages(image, image);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->differing, 0);
  EXPECT_EQ(result->psnr, kInfinity);
  EXPECT_EQ(result->mse, 0.0);
  EXPECT_EQ(result->pixels, 16);
}

// One pixel off by one level, one by two in two channels: the squares add up to 1 + 4 + 4 levels
// over 2 x 2 x 3 samples.
TEST(CompareImages, CountsPixelsAndLevels) {
  ByteImage a(2, 2, 3, 100), b = a;
  b.At(0, 0, 1) = 101;
  b.At(1, 1, 0) = 98;
  b.At(1, 1, 2) = 102;
  const Result<ImageDifference> result = CompareImages(a, b);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->differing, 2);
  EXPECT_EQ(result->beyond_one_level, 1);
  EXPECT_NEAR(result->LargestInLevels(), 2.0, 1e-5);
  EXPECT_NEAR(result->mse, 9.0 / 12 / (255.0 * 255), 1e-11);
  EXPECT_NEAR(result->psnr, 49.3802, 1e-3);  // 10 log10(65025 / 0.75)
}

TEST(CompareImages, OneLevelIsNeverBeyondOneLevel) {
  for (int i = 0; i < 255; ++i) {
    const ByteImage a(1, 1, 1, static_cast<uint8_t>(i)), b(1, 1, 1, static_cast<uint8_t>(i + 1));
    const Result<ImageDifference> result = CompareImages(a, b);
    EXPECT_EQ(result->differing, 1);
    EXPECT_EQ(result->beyond_one_level, 0) << i;
  }
}

// A difference of 1/10 everywhere is 20 dB.
TEST(CompareImages, PsnrOfAKnownDifference) {
  const Result<ImageDifference> result =
      CompareImages(Image(3, 3, 1, 0.25f), Image(3, 3, 1, 0.35f));
  EXPECT_NEAR(result->psnr, 20.0, 1e-5);
  EXPECT_NEAR(result->largest, 0.1, 1e-7);
  EXPECT_NEAR(CompareImages(Image(1, 1, 1, 0), Image(1, 1, 1, 1))->psnr, 0.0, 1e-12);
  EXPECT_NEAR(CompareImages(Image(1, 1, 1, 0), Image(1, 1, 1, 1000))->psnr, -60.0, 1e-9);
}

TEST(CompareImages, NanDiffersFromNumbersOnly) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(CompareImages(Image(1, 1, 1, nan), Image(1, 1, 1, nan))->differing, 0);
  EXPECT_EQ(CompareImages(Image(1, 1, 1, infinity), Image(1, 1, 1, infinity))->differing, 0);
  const Result<ImageDifference> result = CompareImages(Image(1, 1, 1, nan), Image(1, 1, 1, 0.5f));
  EXPECT_EQ(result->differing, 1);
  EXPECT_EQ(result->beyond_one_level, 1);
  EXPECT_EQ(result->largest, kInfinity);
  EXPECT_EQ(result->psnr, -kInfinity);
}

TEST(CompareImages, ChannelsAreMatched) {
  EXPECT_EQ(CompareImages(Image(2, 2, 1, 0.5f), Image(2, 2, 3, 0.5f))->differing, 0);
  Image opaque(2, 2, 4, 0.5f), half(2, 2, 2, 0.5f);
  EXPECT_EQ(CompareImages(opaque, Image(2, 2, 3, 0.5f))->differing, 4);
  for (int i = 0; i < 4; ++i) opaque.At(i % 2, i / 2, 3) = 1;
  EXPECT_EQ(CompareImages(opaque, Image(2, 2, 3, 0.5f))->differing, 0);
  EXPECT_EQ(CompareImages(half, Image(2, 2, 3, 0.5f))->differing, 4);
}

TEST(CompareImages, OtherSizesAreAnError) {
  const Result<ImageDifference> result = CompareImages(Image(2, 3, 1), Image(3, 2, 1));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().message, "the sizes differ: 2 x 3 and 3 x 2");
  EXPECT_FALSE(DifferencePicture(Image(2, 3, 1), Image(3, 2, 1)).ok());
}

TEST(DifferencePicture, ShowsTheSizeTimesTheGain) {
  const Image a(1, 1, 3, 0.5f), b(1, 1, 4, 0.75f);
  const Result<Image> picture = DifferencePicture(a, b, 2);
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(*picture, Image(1, 1, 3, 0.5f));
}

}  // namespace
}  // namespace candela
