#include "image/quantise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/channels.h"

namespace candela {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(QuantiseToByte, TruncatesAndClamps) {
  EXPECT_EQ(QuantiseToByte(0.5f), 127);  // 127.5 is cut, not rounded.
  EXPECT_EQ(QuantiseToByte(1.0f), 255);
  EXPECT_EQ(QuantiseToByte(std::nextafter(1.0f, 0.0f)), 254);
  EXPECT_EQ(QuantiseToByte(std::nextafter(1.0f, 2.0f)), 255);
  EXPECT_EQ(QuantiseToByte(0.0f), 0);
  EXPECT_EQ(QuantiseToByte(-0.0f), 0);
  EXPECT_EQ(QuantiseToByte(-0.001f), 0);
  EXPECT_EQ(QuantiseToByte(-1e9f), 0);
  EXPECT_EQ(QuantiseToByte(1e9f), 255);
  EXPECT_EQ(QuantiseToByte(std::numeric_limits<float>::max()), 255);
  EXPECT_EQ(QuantiseToByte(kInfinity), 255);
  EXPECT_EQ(QuantiseToByte(-kInfinity), 0);
  EXPECT_EQ(QuantiseToByte(kNan), 0);
  EXPECT_EQ(QuantiseToByte(-kNan), 0);
  EXPECT_EQ(QuantiseToByte(0.2f), 51);
}

// Without this, a picture would darken each time that it is read and written.
TEST(QuantiseToByte, GivesBackEveryByte) {
  for (int i = 0; i < 256; ++i) EXPECT_EQ(QuantiseToByte(static_cast<float>(i) / 255.0f), i);
}

TEST(QuantiseToWord, GivesBackEveryWord) {
  for (int i = 0; i < 65536; ++i) {
    ASSERT_EQ(QuantiseToWord(static_cast<float>(i) / 65535.0f), i);
  }
}

// P16
TEST(QuantiseToWord, IsWithinHalfAStepAndClamps) {
  for (int i = 0; i <= 100000; ++i) {
    const float c = static_cast<float>(i) / 100000.0f;
    // 2^-8 allows for the rounding of the product, whose last place is worth that much.
    ASSERT_LE(std::fabs(QuantiseToWord(c) - 65535.0 * c), 0.5 + 1.0 / 256) << c;
  }
  EXPECT_EQ(QuantiseToWord(kNan), 0);
  EXPECT_EQ(QuantiseToWord(kInfinity), 65535);
  EXPECT_EQ(QuantiseToWord(1e9f), 65535);
  EXPECT_EQ(QuantiseToWord(-1.0f), 0);
  EXPECT_EQ(QuantiseToWord(-kInfinity), 0);
}

// 71 samples: two whole groups and a rest.
TEST(QuantiseToBytes, TreatsEverySampleAlike) {
  Image image(71, 1, 1);
  for (int x = 0; x < 71; ++x) image.At(x, 0) = static_cast<float>(x - 10) / 50.0f;
  image.At(5, 0) = kNan;
  image.At(70, 0) = kInfinity;
  const ByteImage bytes = QuantiseToBytes(image);
  const WordImage words = QuantiseToWords(image);
  for (int x = 0; x < 71; ++x) {
    EXPECT_EQ(bytes.At(x, 0), QuantiseToByte(image.At(x, 0)));
    EXPECT_EQ(words.At(x, 0), QuantiseToWord(image.At(x, 0)));
  }
}

TEST(WithChannels, RepeatsGreyAndAddsOrDropsAlpha) {
  Image grey(1, 1, 2);
  grey.At(0, 0, 0) = 0.25f;
  grey.At(0, 0, 1) = 0.5f;
  const Image colour = WithChannels(grey, 4);
  EXPECT_EQ(colour.At(0, 0, 2), 0.25f);
  EXPECT_EQ(colour.At(0, 0, 3), 0.5f);
  EXPECT_EQ(WithChannels(colour, 3).At(0, 0, 0), 0.25f);
  EXPECT_EQ(WithChannels(WithChannels(colour, 3), 4).At(0, 0, 3), 1.0f);
  EXPECT_EQ(WithChannels(grey, 1).At(0, 0), 0.25f);
}

}  // namespace
}  // namespace candela
