#include "image/raster.h"

#include <gtest/gtest.h>

#include "image/size_limit.h"

namespace candela {
namespace {

TEST(Raster, KeepsRowsTopFirstAndSamplesTogether) {
  ByteImage image(3, 2, 2);
  image.At(2, 1, 1) = 7;
  EXPECT_EQ(image.Samples()[11], 7);
  EXPECT_EQ(image.Row(1)[5], 7);
  EXPECT_EQ(image.Pixel(2, 1)[1], 7);
  EXPECT_EQ(image.RowSize(), 6u);
  EXPECT_EQ(image.PixelCount(), 6);
}

TEST(CheckImageSize, JudgesSidesAndProductWithoutOverflow) {
  EXPECT_TRUE(CheckImageSize(1, 1, 1).ok());
  EXPECT_TRUE(CheckImageSize(16, 16, 4, 1024).ok());
  EXPECT_EQ(CheckImageSize(16, 16, 4, 1023).error().code, ErrorCode::kResources);
  EXPECT_EQ(CheckImageSize(0, 5, 1).error().code, ErrorCode::kInput);
  EXPECT_EQ(CheckImageSize(5, -1, 1).error().code, ErrorCode::kInput);
  EXPECT_EQ(CheckImageSize(int64_t{1} << 31, 1, 1).error().code, ErrorCode::kInput);
  EXPECT_EQ(CheckImageSize(INT32_MAX, INT32_MAX, 16, INT64_MAX).error().code,
            ErrorCode::kResources);
}

}  // namespace
}  // namespace candela
