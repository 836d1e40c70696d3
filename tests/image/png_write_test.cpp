#include "image/png_write.h"

#include <gtest/gtest.h>

#include "image/png_read.h"

namespace candela {
namespace {

template <class T>
Raster<T> Pattern(int width, int height, int channels) {
  Raster<T> image(width, height, channels);
  uint32_t state = 1;
  for (T& sample : image.Samples()) {
    state = state * 1664525 + 1013904223;
    sample = static_cast<T>(state >> 13);
  }
  return image;
}

template <class T>
void ExpectRoundTrip() {
  for (int channels = 1; channels <= 4; ++channels) {
    for (const PngEffort effort : {PngEffort::kFast, PngEffort::kSmall}) {
      const Raster<T> image = Pattern<T>(13, 7, channels);
      const Result<std::string> file = EncodePng(image, effort);
      ASSERT_TRUE(file.ok());
      std::vector<std::string> warnings;
      const Result<PngImage> back = DecodePng(*file, &warnings);
      ASSERT_TRUE(back.ok()) << back.error().message;
      EXPECT_TRUE(warnings.empty());
      EXPECT_EQ(std::get<Raster<T>>(back->pixels), image) << channels;
    }
  }
}

// P16
TEST(EncodePng, BytesSurviveTheRoundTrip) {
  ExpectRoundTrip<uint8_t>();
}
// P16
TEST(EncodePng, WordsSurviveTheRoundTrip) {
  ExpectRoundTrip<uint16_t>();
}

TEST(EncodePng, SmallEffortIsNotLarger) {
  ByteImage ramp(256, 64, 3);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 256; ++x) ramp.At(x, y, 1) = static_cast<uint8_t>(x + y * y / 16);
  }
  EXPECT_LE(EncodePng(ramp, PngEffort::kSmall)->size(), EncodePng(ramp)->size());
}

TEST(EncodePng, RefusesWhatTheFormatCannotHold) {
  EXPECT_FALSE(EncodePng(ByteImage()).ok());
  EXPECT_FALSE(EncodePng(ByteImage(2, 2, 5)).ok());
}

}  // namespace
}  // namespace candela
