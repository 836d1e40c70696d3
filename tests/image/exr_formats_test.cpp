// Files as other programs write them: made here by the C++ library, read by the code under test.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>

#include <cmath>
#include <cstring>

#include "image/exr.h"

namespace candela {
namespace {

class StringStream : public Imf::OStream {
 public:
  StringStream() : Imf::OStream("memory") {}
  void write(const char c[], int n) override {
    bytes.resize(std::max(bytes.size(), at + static_cast<size_t>(n)));
    std::memcpy(bytes.data() + at, c, static_cast<size_t>(n));
    at += static_cast<size_t>(n);
  }
  uint64_t tellp() override { return at; }
  void seekp(uint64_t position) override { at = position; }

  std::string bytes;
  size_t at = 0;
};

constexpr int kWidth = 45, kHeight = 37;
// The window begins away from the origin.
const Imath::Box2i kWindow({-3, 5}, {-3 + kWidth - 1, 5 + kHeight - 1});

/// A smooth value that a half holds exactly, so that only lossy compression changes it.
float ValueAt(int x, int y, int c) {
  return static_cast<float>(x + 2 * y + 8 * c) / 64.0f;
}

struct Planes {
  half halves[4][kHeight][kWidth];
  unsigned whole[kHeight][kWidth];
};

std::string Write(const char* names, Imf::Compression compression, bool tiled, bool levels,
                  bool whole_numbers = false) {
  static Planes planes;
  Imf::Header header(kWindow, kWindow);
  header.compression() = compression;
  if (tiled) {
    header.setTileDescription({16, 8, levels ? Imf::MIPMAP_LEVELS : Imf::ONE_LEVEL});
  } else {
    header.lineOrder() = Imf::DECREASING_Y;
  }
  Imf::FrameBuffer frame;
  for (int c = 0; names[c] != 0; ++c) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        planes.halves[c][y][x] = half(ValueAt(x, y, c));
        planes.whole[y][x] = static_cast<unsigned>(x + y);
      }
    }
    const std::string name(1, names[c]);
    const Imf::PixelType type = whole_numbers ? Imf::UINT : Imf::HALF;
    header.channels().insert(name, Imf::Channel(type));
    frame.insert(name, whole_numbers ? Imf::Slice::Make(type, planes.whole, kWindow,
                                                        sizeof(unsigned), sizeof(planes.whole[0]))
                                     : Imf::Slice::Make(type, planes.halves[c], kWindow,
                                                        sizeof(half), sizeof(planes.halves[0][0])));
  }
  StringStream stream;
  if (tiled) {
    Imf::TiledOutputFile file(stream, header);
    file.setFrameBuffer(frame);
    for (int level = 0; level < file.numLevels(); ++level) {
      file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
  } else {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    // The file stores rows from the bottom up, and they are handed over in that order.
    file.writePixels(kHeight);
  }
  return stream.bytes;
}

void ExpectValues(const Result<Image>& image, int channels, float tolerance) {
  ASSERT_TRUE(image.ok()) << image.error().message;
  ASSERT_EQ(image->Width(), kWidth);
  ASSERT_EQ(image->Height(), kHeight);
  ASSERT_EQ(image->Channels(), channels);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < channels; ++c) {
        ASSERT_NEAR(image->At(x, y, c), ValueAt(x, y, c), tolerance) << x << " " << y << " " << c;
      }
    }
  }
}

// P16
TEST(ExrFormats, EveryCompressionInScanlinesTilesAndLevels) {
  for (int compression = 0; compression < Imf::DWAA_COMPRESSION; ++compression) {
    const auto method = static_cast<Imf::Compression>(compression);
    const bool is_lossy = compression >= Imf::B44_COMPRESSION;
    for (int layout = 0; layout < 3; ++layout) {
      SCOPED_TRACE(testing::Message() << "compression " << compression << " layout " << layout);
      ExpectValues(DecodeExr(Write("RGBA", method, layout > 0, layout > 1)), 4,
                   is_lossy ? 0.05f : 0.0f);
    }
  }
}

TEST(ExrFormats, DwaIsRefused) {
  EXPECT_EQ(DecodeExr(Write("RGB", Imf::DWAA_COMPRESSION, false, false)).error().message,
            "the compressions DWAA and DWAB are not supported");
}

// Channels that are not colours are left out.
TEST(ExrFormats, OtherChannelsAreSkipped) {
  ExpectValues(DecodeExr(Write("YUVW", Imf::PIZ_COMPRESSION, false, false)), 1, 0);
  ExpectValues(DecodeExr(Write("RGBZ", Imf::ZIP_COMPRESSION, true, false)), 3, 0);
}

TEST(ExrFormats, GreyWithAndWithoutAlpha) {
  ExpectValues(DecodeExr(Write("Y", Imf::ZIP_COMPRESSION, false, false)), 1, 0);
  ExpectValues(DecodeExr(Write("YA", Imf::ZIP_COMPRESSION, true, false)), 2, 0);
}

TEST(ExrFormats, WholeNumbersBecomeFloats) {
  const Result<Image> image = DecodeExr(Write("Y", Imf::ZIP_COMPRESSION, false, false, true));
  ASSERT_TRUE(image.ok()) << image.error().message;
  EXPECT_EQ(image->At(7, 30), 37.0f);
}

TEST(ExrFormats, SubsampledChannelsAreRefused) {
  Imf::Header header(8, 8);
  header.channels().insert("Y", Imf::Channel(Imf::HALF));
  header.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
  StringStream stream;
  { Imf::OutputFile file(stream, header); }
  EXPECT_EQ(DecodeExr(stream.bytes).error().message,
            "the channel 'BY' is subsampled, which is not supported");
}

// Opened and closed without pixels: the table of blocks is empty.
TEST(ExrFormats, MissingBlocksAreAnError) {
  Imf::Header header(8, 8);
  header.channels().insert("Y", Imf::Channel(Imf::HALF));
  StringStream stream;
  { Imf::OutputFile file(stream, header); }
  EXPECT_FALSE(DecodeExr(stream.bytes).ok());
}

}  // namespace
}  // namespace candela
