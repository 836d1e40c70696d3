#include "image/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <memory>
#include <string>

#include "image/image_file.h"

namespace candela {
namespace {

using testing::HasSubstr;

/// Smooth values, which survive the coding well.
ByteImage Gradient(int width, int height, int channels = 3) {
  ByteImage image(width, height, channels);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c) {
        const int value = c == 0 ? 255 * x / width : c == 1 ? 255 * y / height : 128;
        image.At(x, y, c) = static_cast<uint8_t>(value);
      }
    }
  }
  return image;
}

/// A file as other programs write it: of one, three or four channels, the last being inks.
std::string Compressed(const ByteImage& image, int subsampling, int flags = 0) {
  constexpr int kFormats[] = {TJPF_GRAY, TJPF_UNKNOWN, TJPF_RGB, TJPF_CMYK};
  const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), &tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const int status =
      tjCompress2(encoder.get(), image.Samples().data(), image.Width(), 0, image.Height(),
                  kFormats[image.Channels() - 1], &bytes, &size, subsampling, 90, flags);
  EXPECT_EQ(status, 0) << tjGetErrorStr2(encoder.get());
  const std::string file(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  return file;
}

std::string Message(const std::string& bytes) {
  const auto image = DecodeJpeg(bytes);
  return image ? "" : image.error().message;
}

/// The place of the first marker of this kind.
size_t MarkerAt(const std::string& file, int code, size_t from = 0) {
  const size_t at = file.find(std::string{'\xff', static_cast<char>(code)}, from);
  EXPECT_NE(at, std::string::npos);
  return at;
}

void ExpectNear(const ByteImage& a, const ByteImage& b, int distance) {
  ASSERT_EQ(a.Width(), b.Width());
  ASSERT_EQ(a.Height(), b.Height());
  ASSERT_EQ(a.Channels(), b.Channels());
  for (size_t i = 0; i < a.Samples().size(); ++i) {
    EXPECT_NEAR(a.Samples()[i], b.Samples()[i], distance) << i;
  }
}

TEST(Jpeg, RoundTripIsNearTheOriginal) {
  for (const int channels : {1, 3}) {
    for (const int width : {1, 7, 16, 33}) {
      const ByteImage image = Gradient(width, 20, channels);
      const auto file = EncodeJpeg(image);
      ASSERT_TRUE(file.ok());
      EXPECT_EQ(*file, *EncodeJpeg(image));
      const auto back = DecodeJpeg(*file);
      ASSERT_TRUE(back.ok()) << back.error().message;
      ExpectNear(*back, image, 4);
    }
  }
}

// Subsampled, neighbours would share theirs.
TEST(Jpeg, ColoursAreWrittenAtFullResolution) {
  ByteImage image(16, 16, 3, 50);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) image.At(x, y, x % 2 == 0 ? 0 : 1) = 150;
  }
  const auto back = DecodeJpeg(*EncodeJpeg(image));
  ASSERT_TRUE(back.ok());
  ExpectNear(*back, image, 10);
}

TEST(Jpeg, IsKnownByNameAndByContent) {
  EXPECT_EQ(FormatOf("a.jpg"), ImageFormat::kJpeg);
  EXPECT_EQ(FormatOf("a.JPEG"), ImageFormat::kJpeg);
  const auto file = EncodeImage(Image(3, 2, 3, 0.5f), ImageFormat::kJpeg);
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(FormatOfContent(*file), ImageFormat::kJpeg);
  const auto back = DecodeImage(*file);
  ASSERT_TRUE(back.ok());
  EXPECT_NEAR(back->At(1, 1, 0), 0.5f, 0.01f);
}

TEST(Jpeg, AlphaIsLeftOut) {
  for (const int channels : {2, 4}) {
    const auto file = EncodeImage(Image(8, 8, channels, 0.25f), ImageFormat::kJpeg);
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(DecodeJpeg(*file)->Channels(), channels - 1);
  }
}

TEST(Jpeg, SubsampledColoursAreRead) {
  const ByteImage image = Gradient(40, 30);
  for (const int subsampling : {TJSAMP_420, TJSAMP_422, TJSAMP_440, TJSAMP_411}) {
    const auto back = DecodeJpeg(Compressed(image, subsampling));
    ASSERT_TRUE(back.ok()) << back.error().message;
    ExpectNear(*back, image, 16);
  }
}

// They hold the same coefficients in another order.
TEST(Jpeg, ProgressiveFilesAreThePictureOfBaselineOnes) {
  for (const int channels : {1, 3}) {
    const ByteImage image = Gradient(40, 30, channels);
    const int subsampling = channels == 1 ? TJSAMP_GRAY : TJSAMP_420;
    const std::string baseline = Compressed(image, subsampling);
    const std::string progressive = Compressed(image, subsampling, TJFLAG_PROGRESSIVE);
    EXPECT_NE(progressive, baseline);
    const auto back = DecodeJpeg(progressive);
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(*back, *DecodeJpeg(baseline));
  }
}

TEST(Jpeg, InksAreRefused) {
  EXPECT_EQ(Message(Compressed(Gradient(9, 9, 4), TJSAMP_444)),
            "colours of four inks (CMYK) are not known, only red, green and blue, and grey");
}

TEST(Jpeg, WhatIsCutOffIsRefused) {
  for (const std::string& file : {*EncodeJpeg(Gradient(40, 40)), *EncodeJpeg(Gradient(17, 9, 1)),
                                  Compressed(Gradient(40, 40), TJSAMP_420, TJFLAG_PROGRESSIVE)}) {
    ASSERT_EQ(Message(file), "");
    for (size_t size = 0; size < file.size(); ++size) {
      EXPECT_NE(Message(file.substr(0, size)), "") << size << " of " << file.size();
    }
    EXPECT_EQ(Message(file.substr(0, file.size() - 2)),
              "the picture cannot be decoded: Premature end of JPEG file");
  }
  EXPECT_EQ(Message("GIF89a"), "this is not a JPEG picture");
}

TEST(Jpeg, HugeSizesAreRefusedBeforeMemoryIsTaken) {
  std::string file = *EncodeJpeg(Gradient(8, 8));
  file.replace(MarkerAt(file, 0xC0) + 5, 4, "\xff\xdc\xff\xdc");
  const auto image = DecodeJpeg(file);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::kResources);
  EXPECT_THAT(image.error().message, HasSubstr("a picture of 65500 x 65500 pixels"));
}

TEST(Jpeg, KindsThatAreNotKnownAreNamed) {
  const std::string file = *EncodeJpeg(Gradient(8, 8));
  const size_t frame = MarkerAt(file, 0xC0);
  const auto changed = [&](size_t offset, char value) {
    std::string copy = file;
    copy[frame + offset] = value;
    return Message(copy);
  };
  EXPECT_THAT(changed(1, '\xc3'), HasSubstr("cannot be decoded: Unsupported JPEG process"));
  EXPECT_THAT(changed(4, 12), HasSubstr("Unsupported JPEG data precision 12"));
  EXPECT_THAT(changed(9, 1), HasSubstr("Bogus marker length"));
  EXPECT_THAT(changed(8, 0), HasSubstr("Empty JPEG image"));
}

TEST(Jpeg, TablesThatAreNotPossibleAreRefused) {
  std::string file = *EncodeJpeg(Gradient(8, 8));
  file.replace(MarkerAt(file, 0xC4) + 5, 16, std::string(16, 20));
  EXPECT_EQ(Message(file), "the picture cannot be decoded: Bogus Huffman table definition");
}

TEST(Jpeg, DamagedDataIsRefused) {
  std::string file = *EncodeJpeg(Gradient(64, 64));
  const size_t scan = MarkerAt(file, 0xDA);
  file.replace(scan + 40, 60, std::string(60, '\x55'));
  EXPECT_THAT(Message(file), HasSubstr("the picture cannot be decoded: Corrupt JPEG data"));
}

// A few bytes each, over a picture that may be large.
TEST(Jpeg, ScansWithoutEndAreRefused) {
  const std::string file = Compressed(ByteImage(8, 8, 1, 77), TJSAMP_GRAY, TJFLAG_PROGRESSIVE);
  const size_t begin = MarkerAt(file, 0xDA), end = MarkerAt(file, 0xC4, begin);
  std::string scan = file.substr(begin, end - begin);
  scan[9] = 0;  // All bits of the value, so that it may come again.
  const auto with_scans = [&](int count) {
    std::string repeated = file.substr(0, begin);
    for (int i = 0; i < count; ++i) repeated += scan;
    return repeated + "\xff\xd9";
  };
  EXPECT_EQ(Message(with_scans(3)), "");
  EXPECT_THAT(Message(with_scans(600)), HasSubstr("more than 500 scans"));
}

TEST(Jpeg, WhatCannotBeWrittenIsRefused) {
  EXPECT_EQ(EncodeJpeg(ByteImage(65501, 1, 3)).error().message,
            "a side of a JPEG picture has at most 65500 pixels");
  EXPECT_TRUE(EncodeJpeg(ByteImage(65500, 1, 3)).ok());
  for (const int channels : {2, 4}) {
    EXPECT_EQ(EncodeJpeg(ByteImage(3, 3, channels)).error().message,
              "a JPEG file holds grey or colours and at least one pixel");
  }
  EXPECT_FALSE(EncodeJpeg(ByteImage()).ok());
}

}  // namespace
}  // namespace candela
