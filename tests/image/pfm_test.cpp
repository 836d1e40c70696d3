#include "image/pfm.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/image/png_builder.h"

namespace candela {
namespace {

std::string ErrorOf(const std::string& file) {
  const Result<Image> result = DecodePfm(file);
  return result.ok() ? "no error" : result.error().message;
}

// P16
TEST(Pfm, RoundTripKeepsEveryBit) {
  for (const int channels : {1, 3}) {
    for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig}) {
      Image image(5, 3, channels);
      float value = -1e-30f;
      for (float& sample : image.Samples()) sample = value *= -7.3f;
      image.At(0, 0) = std::numeric_limits<float>::infinity();
      image.At(1, 0) = std::numeric_limits<float>::denorm_min();
      const Result<Image> back = DecodePfm(*EncodePfm(image, order));
      ASSERT_TRUE(back.ok()) << back.error().message;
      EXPECT_EQ(*back, image);
    }
  }
}

TEST(Pfm, NanSurvives) {
  const Image image(1, 1, 1, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(std::isnan(DecodePfm(*EncodePfm(image))->At(0, 0)));
}

// 1.0f is 3f 80 00 00; the first row of the file is the bottom one.
TEST(Pfm, KnownBytes) {
  const std::string one = Bytes({0x3f, 0x80, 0, 0}), two = Bytes({0x40, 0, 0, 0});
  const Result<Image> big = DecodePfm("Pf\n1 2\n1.0\n" + one + two);
  ASSERT_TRUE(big.ok());
  EXPECT_EQ(big->At(0, 1), 1.0f);
  EXPECT_EQ(big->At(0, 0), 2.0f);
  const Result<Image> little = DecodePfm("Pf 1 1 -2.5\n" + Bytes({0, 0, 0x80, 0x3f}));
  ASSERT_TRUE(little.ok());
  EXPECT_EQ(little->At(0, 0), 1.0f);
}

TEST(Pfm, AlphaIsLeftOut) {
  EXPECT_EQ(DecodePfm(*EncodePfm(Image(2, 1, 4, 0.5f)))->Channels(), 3);
  EXPECT_EQ(DecodePfm(*EncodePfm(Image(2, 1, 2, 0.5f)))->Channels(), 1);
}

TEST(Pfm, WrongFilesAreErrors) {
  EXPECT_EQ(ErrorOf(""), "this is not a portable float map");
  EXPECT_EQ(ErrorOf(" PF 1 1 -1\n"), "this is not a portable float map");
  EXPECT_EQ(ErrorOf("PF4 1 1 -1\n"), "this is not a portable float map");
  EXPECT_EQ(ErrorOf("PF 1 x -1\n"),
            "expected width, height and a scale other than 0, found '1', 'x', '-1'");
  EXPECT_EQ(ErrorOf("PF 1 1 0\n"),
            "expected width, height and a scale other than 0, found '1', '1', '0'");
  EXPECT_EQ(ErrorOf("PF 1 1 nan\n"),
            "expected width, height and a scale other than 0, found '1', '1', 'nan'");
  EXPECT_EQ(ErrorOf("PF 1 -1 1\n"), "a picture of 1 x -1 pixels is not possible");
  EXPECT_EQ(ErrorOf("PF 1 1 1\n12345678901"), "there is too little data: 11 of 12 bytes");
  EXPECT_EQ(DecodePfm("PF 2000000000 2000000000 1\n").error().code, ErrorCode::kResources);
}

TEST(Pfm, SurplusDataIsAWarning) {
  std::vector<std::string> warnings;
  EXPECT_TRUE(DecodePfm("Pf 1 1 1\n12345", &warnings).ok());
  EXPECT_THAT(warnings, testing::ElementsAre("there is more data than the picture needs"));
}

TEST(Pfm, AFileCutAnywhereIsAnError) {
  const std::string file = *EncodePfm(Image(3, 2, 3, 1.0f));
  for (size_t size = 0; size < file.size(); ++size) {
    EXPECT_FALSE(DecodePfm(file.substr(0, size)).ok()) << size;
  }
}

}  // namespace
}  // namespace candela
