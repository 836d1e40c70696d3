#include "image/exr.h"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>

namespace candela {
namespace {

using ::testing::ElementsAre;

Image Values(int width, int height, int channels) {
  Image image(width, height, channels);
  float value = 1e-12f;
  for (float& sample : image.Samples()) {
    value *= -1.3f;
    if (value > 1e20f || value < -1e20f) value = 1e-12f;
    sample = value;
  }
  return image;
}

std::string Little(uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift));
  return bytes;
}

// P16
TEST(Exr, RoundTripKeepsEveryBit) {
  for (int channels = 1; channels <= 4; ++channels) {
    // 37 rows are more than two blocks of 16.
    Image image = Values(21, 37, channels);
    image.At(3, 20) = std::numeric_limits<float>::infinity();
    image.At(4, 20) = std::numeric_limits<float>::denorm_min();
    const Result<std::string> file = EncodeExr(image);
    ASSERT_TRUE(file.ok()) << file.error().message;
    const Result<Image> back = DecodeExr(*file);
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(*back, image);
  }
}

// Blocks of all sizes, among them some that compression leaves as large as they were.
TEST(Exr, SmallBlocksSurviveToo) {
  for (int width = 1; width <= 24; ++width) {
    for (int height = 1; height <= 4; ++height) {
      for (const float value : {5.0f, 0.1f}) {
        Image image(width, height, 1, value);
        for (int x = 0; x < width; x += 3) image.At(x, 0) += static_cast<float>(x);
        const Result<Image> back = DecodeExr(*EncodeExr(image));
        ASSERT_TRUE(back.ok());
        EXPECT_EQ(*back, image) << width << " x " << height;
        EXPECT_EQ(*DecodeExr(*EncodeExr(Image(width, height, 1, value))),
                  Image(width, height, 1, value));
      }
    }
  }
}

TEST(Exr, SamePictureGivesTheSameBytes) {
  EXPECT_EQ(*EncodeExr(Values(9, 20, 3)), *EncodeExr(Values(9, 20, 3)));
}

TEST(Exr, ChannelsKeepTheirNames) {
  const Image image = Values(5, 4, 5);
  const std::string names[] = {"R", "G", "B", "Z", "albedo.R"};
  const Result<std::string> file = EncodeExr(image, names);
  ASSERT_TRUE(file.ok()) << file.error().message;
  const Result<ExrPicture> all = DecodeExrChannels(*file);
  ASSERT_TRUE(all.ok()) << all.error().message;
  EXPECT_THAT(all->channels, ElementsAre("B", "G", "R", "Z", "albedo.R"));
  const Result<Image> colours = DecodeExr(*file);
  ASSERT_TRUE(colours.ok());
  ASSERT_EQ(colours->Channels(), 3);
  for (int x = 0; x < 5; ++x) {
    EXPECT_EQ(all->image.At(x, 2, 0), image.At(x, 2, 2));
    EXPECT_EQ(all->image.At(x, 2, 3), image.At(x, 2, 3));
    EXPECT_EQ(all->image.At(x, 2, 4), image.At(x, 2, 4));
    EXPECT_EQ(colours->At(x, 2, 0), image.At(x, 2, 0));
  }
}

// Names of more than 31 characters are marked in the header; files without them stay as they were.
TEST(Exr, LongNamesOfChannelsAreMarked) {
  constexpr size_t kFlags = 5;
  constexpr char kLongNames = 0x4;
  for (const size_t size : {31u, 32u, 78u}) {
    const std::vector<std::string> names = {std::string(size, 'x')};
    const Image image = Values(3, 2, 1);
    const Result<std::string> file = EncodeExr(image, names);
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_EQ(((*file)[kFlags] & kLongNames) != 0, size > 31) << size;
    const Result<ExrPicture> back = DecodeExrChannels(*file);
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(back->channels, names);
    EXPECT_EQ(back->image, image);
  }
}

TEST(Exr, ColoursAreChosenByName) {
  const std::string depth[] = {"Z"};
  EXPECT_EQ(*DecodeExr(*EncodeExr(Image(2, 2, 1, 5), depth)), Image(2, 2, 1, 5));
  const std::string other[] = {"u", "v"};
  EXPECT_EQ(DecodeExr(*EncodeExr(Image(2, 2, 2), other)).error().message,
            "there is neither a set of channels R, G, B nor a channel Y");
}

TEST(Exr, WrongFilesAreErrors) {
  EXPECT_FALSE(DecodeExr("").ok());
  EXPECT_FALSE(DecodeExr("\x76\x2f\x31\x01").ok());
  EXPECT_FALSE(DecodeExr(std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) + std::string(99, 'x')).ok());
}

TEST(Exr, LimitIsChecked) {
  const std::string file = *EncodeExr(Image(8, 8, 3));
  EXPECT_TRUE(DecodeExr(file, 8 * 8 * 12).ok());
  EXPECT_EQ(DecodeExr(file, 8 * 8 * 12 - 1).error().code, ErrorCode::kResources);
}

TEST(Exr, HeaderThatPromisesMoreThanTheFileCanHoldIsAnError) {
  std::string file = *EncodeExr(Image(8, 8, 1));
  const size_t window = file.find("dataWindow");
  ASSERT_NE(window, std::string::npos);
  const size_t max_x = window + std::strlen("dataWindow") + 1 + std::strlen("box2i") + 1 + 4 + 8;
  ASSERT_EQ(file.substr(max_x, 8), Little(7) + Little(7));
  file.replace(max_x + 4, 4, Little(20000000));
  EXPECT_FALSE(DecodeExr(file).ok());
  file.replace(max_x, 8, Little(0x7fffffff) + Little(0x7fffffff));
  EXPECT_FALSE(DecodeExr(file).ok());
}

TEST(Exr, AFileCutAnywhereIsAnError) {
  const std::string file = *EncodeExr(Values(6, 20, 3));
  for (size_t size = 0; size < file.size(); ++size) {
    ASSERT_FALSE(DecodeExr(file.substr(0, size)).ok()) << size;
  }
}

TEST(Exr, AnyChangedByteIsHandled) {
  const std::string file = *EncodeExr(Values(6, 20, 3));
  for (size_t i = 0; i < file.size(); ++i) {
    for (const int change : {1, 0x10, 0x80, 0xff}) {
      std::string changed = file;
      changed[i] = static_cast<char>(changed[i] ^ change);
      const Result<Image> result = DecodeExr(changed, 1 << 20);
      if (!result.ok()) {
        EXPECT_FALSE(result.error().message.empty());
      }
    }
  }
}

TEST(Exr, RefusesAnEmptyPicture) {
  EXPECT_FALSE(EncodeExr(Image()).ok());
}

}  // namespace
}  // namespace candela
