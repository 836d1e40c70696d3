#include "image/contact_sheet.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(ShrinkImage, IsTheMeanOfTheCoveredArea) {
  Image image(4, 2, 1);
  for (int x = 0; x < 4; ++x) {
    image.At(x, 0) = static_cast<float>(x);
    image.At(x, 1) = static_cast<float>(x + 4);
  }
  const Image small = ShrinkImage(image, 2, 1);
  EXPECT_EQ(small.At(0, 0), 2.5f);  // 0 1 4 5
  EXPECT_EQ(small.At(1, 0), 4.5f);  // 2 3 6 7
}

// Three pixels into two: each new one covers one and a half.
TEST(ShrinkImage, CountsPixelsAtTheEdgeByTheirPart) {
  Image image(3, 1, 1);
  image.At(0, 0) = 3;
  image.At(1, 0) = 6;
  image.At(2, 0) = 12;
  const Image small = ShrinkImage(image, 2, 1);
  EXPECT_FLOAT_EQ(small.At(0, 0), 4.0f);
  EXPECT_FLOAT_EQ(small.At(1, 0), 10.0f);
}

TEST(ShrinkImage, SameSizeIsTheSamePicture) {
  Image image(3, 3, 2, 0.1f);
  image.At(1, 2, 1) = 7;
  EXPECT_EQ(ShrinkImage(image, 3, 3), image);
}

TEST(MakeContactSheet, PlacesPicturesInRows) {
  // A wide picture, a small grey one, a large one with alpha.
  const Image images[] = {Image(8, 4, 3, 0.25f), Image(2, 2, 1, 0.5f), Image(8, 8, 4, 0.75f)};
  SheetLayout layout;
  layout.columns = 2;
  layout.cell_width = layout.cell_height = 4;
  layout.margin = 1;
  const Image sheet = MakeContactSheet(images, layout);
  ASSERT_EQ(sheet.Width(), 11);
  ASSERT_EQ(sheet.Height(), 11);
  ASSERT_EQ(sheet.Channels(), 3);
  EXPECT_EQ(sheet.At(0, 0, 0), 1.0f);  // margin
  EXPECT_EQ(sheet.At(1, 1, 0), 1.0f);  // above the wide picture, which takes two rows of four
  EXPECT_EQ(sheet.At(1, 2, 0), 0.25f);
  EXPECT_EQ(sheet.At(4, 3, 2), 0.25f);
  EXPECT_EQ(sheet.At(4, 4, 2), 1.0f);
  EXPECT_EQ(sheet.At(6, 2, 0), 1.0f);  // beside the small one, which is not enlarged
  EXPECT_EQ(sheet.At(7, 2, 1), 0.5f);
  EXPECT_EQ(sheet.At(8, 3, 1), 0.5f);
  EXPECT_EQ(sheet.At(9, 3, 1), 1.0f);
  EXPECT_EQ(sheet.At(1, 6, 0), 0.75f);  // second row
  EXPECT_EQ(sheet.At(4, 9, 0), 0.75f);
  EXPECT_EQ(sheet.At(6, 6, 0), 1.0f);  // empty cell
}

}  // namespace
}  // namespace candela
