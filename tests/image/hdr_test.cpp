#include "image/hdr.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/image/png_builder.h"

namespace candela {
namespace {

const std::string kHead = "#?RADIANCE\nSOFTWARE=x\nFORMAT=32-bit_rle_rgbe\n\n";

std::string ErrorOf(const std::string& file) {
  const Result<Image> result = DecodeHdr(file);
  return result.ok() ? "no error" : result.error().message;
}

Image Ramp(int width, int height) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.At(x, y, 0) = std::ldexp(1.0f + static_cast<float>(x) / 37.0f, y % 40 - 20);
      image.At(x, y, 1) = x < width / 2 ? 0.5f : static_cast<float>(x * y);
      image.At(x, y, 2) = x / 9 % 2 == 0 ? 0.0f : 1.0f;
    }
  }
  return image;
}

// P16: the mantissa of the largest channel has 8 bits, so its error is at most 1/256 of it, and
// half of that since the encoder rounds; the other channels share its step.
TEST(Hdr, RoundTripIsWithinHalfAStep) {
  for (const int width : {1, 7, 8, 130, 300}) {
    const Image image = Ramp(width, 41);
    const Result<std::string> file = EncodeHdr(image);
    ASSERT_TRUE(file.ok());
    const Result<Image> back = DecodeHdr(*file);
    ASSERT_TRUE(back.ok()) << back.error().message;
    ASSERT_EQ(back->Width(), width);
    ASSERT_EQ(back->Height(), 41);
    for (int y = 0; y < 41; ++y) {
      for (int x = 0; x < width; ++x) {
        const float most = std::max({image.At(x, y, 0), image.At(x, y, 1), image.At(x, y, 2)});
        for (int c = 0; c < 3; ++c) {
          ASSERT_LE(std::fabs(back->At(x, y, c) - image.At(x, y, c)), most / 256) << x << " " << y;
        }
      }
    }
    // What the format can hold is held exactly.
    EXPECT_EQ(*EncodeHdr(*back), *file);
  }
}

TEST(Hdr, ExtremesAreClamped) {
  Image image(4, 1, 3);
  image.At(0, 0, 0) = -1.0f;
  image.At(1, 0, 1) = std::numeric_limits<float>::quiet_NaN();
  image.At(2, 0, 2) = std::numeric_limits<float>::infinity();
  image.At(3, 0, 0) = 0.99999994f;  // Rounds up to 1, which has the next exponent.
  const Result<Image> back = DecodeHdr(*EncodeHdr(image));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->At(0, 0, 0), 0.0f);
  EXPECT_EQ(back->At(1, 0, 1), 0.0f);
  EXPECT_EQ(back->At(2, 0, 2), 0x1.fep+126f);
  EXPECT_EQ(back->At(3, 0, 0), 1.0f);
}

TEST(Hdr, GreyIsRepeated) {
  const Result<Image> back = DecodeHdr(*EncodeHdr(Image(2, 2, 1, 3.0f)));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(*back, Image(2, 2, 3, 3.0f));
}

// 128 * 2^(129 - 136) = 1.
TEST(Hdr, PlainPixels) {
  const Result<Image> image =
      DecodeHdr(kHead + "-Y 1 +X 2\n" + Bytes({128, 64, 0, 129, 5, 6, 7, 0}));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->At(0, 0, 0), 1.0f);
  EXPECT_EQ(image->At(0, 0, 1), 0.5f);
  EXPECT_EQ(image->At(1, 0, 0), 0.0f);  // An exponent of 0 is black.
}

TEST(Hdr, OldRunsRepeatThePixelBefore) {
  // One pixel, then 2 + 1 * 256 repeats of it.
  const std::string pixel = Bytes({128, 0, 0, 129});
  const Result<Image> image =
      DecodeHdr(kHead + "-Y 1 +X 259\n" + pixel + Bytes({1, 1, 1, 2, 1, 1, 1, 1}));
  ASSERT_TRUE(image.ok()) << image.error().message;
  for (int x = 0; x < 259; ++x) EXPECT_EQ(image->At(x, 0, 0), 1.0f);
}

TEST(Hdr, NewRunsGoByComponent) {
  const std::string row =
      Bytes({2, 2, 0, 8, /*r*/ 128 + 8, 128, /*g*/ 3, 64, 0, 64, 128 + 5, 0, /*b*/ 128 + 8, 0,
             /*e*/ 128 + 7, 129, 1, 130});
  const Result<Image> image = DecodeHdr(kHead + "-Y 1 +X 8\n" + row);
  ASSERT_TRUE(image.ok()) << image.error().message;
  EXPECT_EQ(image->At(0, 0, 0), 1.0f);
  EXPECT_EQ(image->At(0, 0, 1), 0.5f);
  EXPECT_EQ(image->At(1, 0, 1), 0.0f);
  EXPECT_EQ(image->At(7, 0, 0), 2.0f);
}

TEST(Hdr, SignsOfTheSizeMirror) {
  const std::string pixels =
      Bytes({128, 0, 0, 129, 128, 0, 0, 130, 128, 0, 0, 131, 128, 0, 0, 132});
  const auto at = [&](const char* size, int x, int y) {
    const Result<Image> image = DecodeHdr(kHead + size + "\n" + pixels);
    return image.ok() ? image->At(x, y, 0) : -1.0f;
  };
  EXPECT_EQ(at("-Y 2 +X 2", 0, 0), 1.0f);
  EXPECT_EQ(at("+Y 2 +X 2", 0, 1), 1.0f);
  EXPECT_EQ(at("-Y 2 -X 2", 1, 0), 1.0f);
  EXPECT_EQ(at("+Y 2 -X 2", 1, 1), 1.0f);
  EXPECT_EQ(ErrorOf(kHead + "+X 2 -Y 2\n" + pixels),
            "pictures stored by columns are not supported");
}

TEST(Hdr, WrongFilesAreErrors) {
  EXPECT_EQ(ErrorOf("P6"), "this is not a Radiance picture");
  EXPECT_EQ(ErrorOf("#?RADIANCE\n"), "the file ends inside its header");
  EXPECT_EQ(ErrorOf("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n"),
            "the format '32-bit_rle_xyze' is not supported");
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 1.5\n"),
            "expected a size such as '-Y 480 +X 640', found '-Y 1 +X 1.5'");
  EXPECT_EQ(ErrorOf(kHead + "-Y 0 +X 7\n"), "a picture of 7 x 0 pixels is not possible");
  EXPECT_EQ(ErrorOf(kHead + "-Y 2 +X 1\n" + Bytes({1, 2, 3, 4})),
            "there is too little data for a picture of this size");
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 2\n" + Bytes({1, 2, 3, 4})),
            "there is too little data for a picture of this size");
  // A run before any pixel, one that is longer than the row, a literal of no length, the wrong
  // width.
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 2\n" + Bytes({1, 1, 1, 2, 9, 9, 9, 9})),
            "row 1 is damaged or cut off");
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 2\n" + Bytes({9, 1, 1, 2, 1, 1, 1, 2})),
            "row 1 is damaged or cut off");
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 8\n" + Bytes({2, 2, 0, 8, 0, 0, 0, 0})),
            "row 1 is damaged or cut off");
  // Rows of four pixels, of which the second is cut off in its first pixel, and in its second.
  const std::string pixel = Bytes({128, 0, 0, 129}), row = pixel + pixel + pixel + pixel;
  for (const size_t left : {2, 6}) {
    EXPECT_EQ(ErrorOf(kHead + "-Y 2 +X 4\n" + row + row.substr(0, left)),
              "row 2 is damaged or cut off");
  }
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 8\n" + Bytes({2, 2, 0, 9, 137, 1, 137, 1, 137, 1, 137, 1})),
            "row 1 is damaged or cut off");
}

// The widest row of 16 bytes: a pixel, and 255, 255 * 2^8 and 255 * 2^16 repeats of it.
TEST(Hdr, TheSizeIsHeldAgainstTheBytes) {
  const std::string widest = Bytes({128, 0, 0, 129, 1, 1, 1, 255, 1, 1, 1, 255, 1, 1, 1, 255});
  EXPECT_TRUE(DecodeHdr(kHead + "-Y 1 +X 16777216\n" + widest).ok());
  constexpr const char* kTooLittle = "there is too little data for a picture of this size";
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 16777217\n" + widest), kTooLittle);
  EXPECT_EQ(ErrorOf(kHead + "-Y 2 +X 65537\n" + widest), kTooLittle);
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 178000000\n" + Bytes({1, 2, 3, 4})), kTooLittle);
  EXPECT_EQ(ErrorOf(kHead + "-Y 1 +X 257\n" + widest.substr(0, 8)), kTooLittle);
}

TEST(Hdr, LimitIsChecked) {
  const Result<Image> image = DecodeHdr(kHead + "-Y 1 +X 2147483647\n" + Bytes({1, 2, 3, 4}));
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::kResources);
}

TEST(Hdr, SurplusDataIsAWarning) {
  std::vector<std::string> warnings;
  EXPECT_TRUE(DecodeHdr(*EncodeHdr(Image(2, 2, 3)) + "x", &warnings).ok());
  EXPECT_THAT(warnings, testing::ElementsAre("there is more data than the picture needs"));
}

TEST(Hdr, AFileCutAnywhereIsAnError) {
  const std::string file = *EncodeHdr(Ramp(9, 3));
  for (size_t size = 0; size < file.size(); ++size) {
    EXPECT_FALSE(DecodeHdr(file.substr(0, size)).ok()) << size;
  }
}

}  // namespace
}  // namespace candela
