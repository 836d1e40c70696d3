#include "image/image_file.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

/// Colours from far below one level to far above white.
Image WideRange() {
  Image image(16, 8, 3);
  float value = 1e-9f;
  for (float& sample : image.Samples()) sample = value *= 1.07f;
  return image;
}

TEST(FormatOf, GoesByTheExtensionInAnyCase) {
  EXPECT_EQ(FormatOf("a/b.png"), ImageFormat::kPng);
  EXPECT_EQ(FormatOf("B.EXR"), ImageFormat::kExr);
  EXPECT_EQ(FormatOf("x.tar.Hdr"), ImageFormat::kHdr);
  EXPECT_EQ(FormatOf("x.pfm"), ImageFormat::kPfm);
  EXPECT_EQ(FormatOf("png"), std::nullopt);
  EXPECT_EQ(FormatOf("x.Jpeg"), ImageFormat::kJpeg);
  EXPECT_EQ(FormatOf("x.jpg"), ImageFormat::kJpeg);
  EXPECT_EQ(FormatOf("x.gif"), std::nullopt);
  EXPECT_EQ(FormatOf(""), std::nullopt);
}

TEST(EncodeImage, ContentShowsTheFormat) {
  for (const ImageFormat format : {ImageFormat::kPng, ImageFormat::kJpeg, ImageFormat::kExr,
                                   ImageFormat::kHdr, ImageFormat::kPfm}) {
    const Result<std::string> file = EncodeImage(WideRange(), format);
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_EQ(FormatOfContent(*file), format);
  }
}

// Values far below 1e-6 and above 1 come back unchanged from the formats that hold floats.
TEST(EncodeImage, FloatFormatsKeepEveryValue) {
  const Image image = WideRange();
  EXPECT_LT(image.At(0, 0, 0), 1e-6f);
  EXPECT_GT(image.At(15, 7, 2), 100.0f);
  EXPECT_EQ(*DecodeImage(*EncodeImage(image, ImageFormat::kExr)), image);
  EXPECT_EQ(*DecodeImage(*EncodeImage(image, ImageFormat::kPfm)), image);
}

TEST(EncodeImage, HdrKeepsEightBitsOfThePixel) {
  const Image image = WideRange();
  const Image back = *DecodeImage(*EncodeImage(image, ImageFormat::kHdr));
  for (int x = 0; x < 16; ++x) {
    const float most = image.At(x, 3, 2);  // The values grow, so the last channel is the largest.
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(back.At(x, 3, c), image.At(x, 3, c), most / 256);
    }
  }
}

TEST(EncodeImage, PngKeepsLevels) {
  Image image(101, 1, 1);
  for (int x = 0; x <= 100; ++x) image.At(x, 0) = static_cast<float>(x) / 100.0f;
  const Image bytes = *DecodeImage(*EncodeImage(image, ImageFormat::kPng));
  EncodeOptions options;
  options.png_bits = 16;
  const Image words = *DecodeImage(*EncodeImage(image, ImageFormat::kPng, options));
  for (int x = 0; x <= 100; ++x) {
    const float error = image.At(x, 0) - bytes.At(x, 0);  // The course cuts, so never upwards.
    EXPECT_GE(error, -1e-7f);
    EXPECT_LT(error, 1.0f / 255);
    EXPECT_NEAR(words.At(x, 0), image.At(x, 0), 0.502 / 65535);
  }
  // What was read from a file is written unchanged.
  EXPECT_EQ(*DecodeImage(*EncodeImage(bytes, ImageFormat::kPng)), bytes);
  EXPECT_EQ(*DecodeImage(*EncodeImage(words, ImageFormat::kPng, options)), words);
}

TEST(DecodeImage, UnknownContentIsAnError) {
  EXPECT_EQ(DecodeImage("GIF89a").error().message,
            "this is not a PNG, JPEG, EXR, HDR or PFM picture");
  EXPECT_EQ(DecodeImage("").error().code, ErrorCode::kInput);
}

TEST(ReadImage, GoesByContentAndReportsTheFile) {
  const testing_support::TempFolder folder;
  const std::filesystem::path path = folder / "floats.png";
  const Image image = WideRange();
  const std::string file = *EncodeImage(image, ImageFormat::kPfm);
  ASSERT_TRUE(WriteFileAtomically(path, std::as_bytes(std::span(file))).ok());
  EXPECT_EQ(*ReadImage(path), image);
  EXPECT_EQ(ReadImage(folder / "none.png").error().message, "no such file");
}

}  // namespace
}  // namespace candela
