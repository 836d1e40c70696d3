// Every colour type and depth, plain and interlaced, against known pixels.
#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

#include "image/png_read.h"
#include "tests/image/png_builder.h"

namespace candela {
namespace {

struct Format {
  int colour, depth, samples;
};
constexpr Format kFormats[] = {{0, 1, 1}, {0, 2, 1},  {0, 4, 1},  {0, 8, 1}, {0, 16, 1},
                               {2, 8, 3}, {2, 16, 3}, {3, 1, 1},  {3, 2, 1}, {3, 4, 1},
                               {3, 8, 1}, {4, 8, 2},  {4, 16, 2}, {6, 8, 4}, {6, 16, 4}};

/// Some sample that depends on its place.
int SampleAt(const Format& format, int x, int y, int c) {
  return (x * 7 + y * 13 + c * 29 + x * y * 31) * 2654435761u >> 7 & ((1u << format.depth) - 1);
}

/// A grey ramp with a tint, as long as the depth allows.
int PaletteEntry(int index, int c) {
  return (index * (37 + c) + 11 * c) & 255;
}

/// The scanlines of a part of the picture, filtered by turns with all five filters.
std::string Scanlines(const Format& format, int width, int height, int x0, int y0, int dx, int dy) {
  std::string result;
  const auto step = static_cast<size_t>(std::max(1, format.samples * format.depth / 8));
  std::string prior;
  int filter = 0;
  for (int y = y0; y < height; y += dy) {
    std::string bits;
    for (int x = x0; x < width; x += dx) {
      for (int c = 0; c < format.samples; ++c) {
        for (int bit = format.depth - 1; bit >= 0; --bit) {
          bits.push_back(SampleAt(format, x, y, c) >> bit & 1 ? '1' : '0');
        }
      }
    }
    if (bits.empty()) return {};
    bits.resize((bits.size() + 7) / 8 * 8, '0');
    std::string row;
    for (size_t i = 0; i < bits.size(); i += 8) {
      row.push_back(static_cast<char>(std::strtol(bits.substr(i, 8).c_str(), nullptr, 2)));
    }
    prior.resize(row.size());
    result += Filtered(filter, step, row, prior);
    prior = row;
    filter = (filter + 1) % 5;
  }
  return result;
}

std::string AllScanlines(const Format& format, int width, int height, bool interlaced) {
  if (!interlaced) return Scanlines(format, width, height, 0, 0, 1, 1);
  // The passes, from the table in the standard.
  return Scanlines(format, width, height, 0, 0, 8, 8) +
         Scanlines(format, width, height, 4, 0, 8, 8) +
         Scanlines(format, width, height, 0, 4, 4, 8) +
         Scanlines(format, width, height, 2, 0, 4, 4) +
         Scanlines(format, width, height, 0, 2, 2, 4) +
         Scanlines(format, width, height, 1, 0, 2, 2) +
         Scanlines(format, width, height, 0, 1, 1, 2);
}

int Expected(const Format& format, int x, int y, int c) {
  if (format.colour == 3) return PaletteEntry(SampleAt(format, x, y, 0), c);
  const int sample = SampleAt(format, x, y, c);
  switch (format.depth) {
    case 1:
      return sample * 255;
    case 2:
      return sample * 85;
    case 4:
      return sample * 17;
    default:
      return sample;
  }
}

TEST(PngFormats, EveryColourTypeDepthAndInterlacingGivesItsPixels) {
  for (const Format& format : kFormats) {
    for (const bool interlaced : {false, true}) {
      for (int width = 1; width <= 17; width += 4) {
        for (int height = 1; height <= 13; height += 3) {
          SCOPED_TRACE(testing::Message()
                       << "colour " << format.colour << " depth " << format.depth
                       << (interlaced ? " interlaced " : " plain ") << width << " x " << height);
          std::string palette;
          for (int i = 0; i < 1 << format.depth && format.colour == 3; ++i) {
            for (int c = 0; c < 3; ++c) palette.push_back(static_cast<char>(PaletteEntry(i, c)));
          }
          std::vector<std::string> chunks{PngHeader(static_cast<uint32_t>(width),
                                                    static_cast<uint32_t>(height), format.depth,
                                                    format.colour, interlaced)};
          if (format.colour == 3) chunks.push_back(PngChunk("PLTE", palette));
          chunks.push_back(
              PngChunk("IDAT", Deflate(AllScanlines(format, width, height, interlaced))));
          chunks.push_back(PngChunk("IEND", ""));
          std::vector<std::string> warnings;
          const Result<PngImage> png = DecodePng(PngFile(chunks), &warnings);
          ASSERT_TRUE(png.ok()) << png.error().message;
          EXPECT_TRUE(warnings.empty());
          ASSERT_EQ(png->Width(), width);
          ASSERT_EQ(png->Height(), height);
          ASSERT_EQ(png->Channels(), format.colour == 3 ? 3 : format.samples);
          ASSERT_EQ(std::holds_alternative<WordImage>(png->pixels), format.depth == 16);
          for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
              for (int c = 0; c < png->Channels(); ++c) {
                const int value = std::holds_alternative<WordImage>(png->pixels)
                                      ? std::get<WordImage>(png->pixels).At(x, y, c)
                                      : std::get<ByteImage>(png->pixels).At(x, y, c);
                ASSERT_EQ(value, Expected(format, x, y, c)) << x << " " << y << " " << c;
              }
            }
          }
        }
      }
    }
  }
}

TEST(PngFormats, TransparentEntriesOfAPaletteBecomeAlpha) {
  // Three entries, two of them in the table of alphas.
  const Result<PngImage> png = DecodePng(PngFile(
      {PngHeader(3, 1, 8, 3), PngChunk("PLTE", "abcdefghi"), PngChunk("tRNS", Bytes({0, 128})),
       PngChunk("IDAT", Deflate(Bytes({0, 0, 1, 2}))), PngChunk("IEND", "")}));
  ASSERT_TRUE(png.ok());
  const auto& image = std::get<ByteImage>(png->pixels);
  ASSERT_EQ(image.Channels(), 4);
  EXPECT_EQ(image.At(0, 0, 3), 0);
  EXPECT_EQ(image.At(1, 0, 3), 128);
  EXPECT_EQ(image.At(2, 0, 3), 255);
  EXPECT_EQ(image.At(1, 0, 0), 'd');
}

TEST(PngFormats, TransparentColourBecomesAlpha) {
  const Result<PngImage> grey =
      DecodePng(PngFile({PngHeader(2, 1, 4, 0), PngChunk("tRNS", Bytes({0, 3})),
                         PngChunk("IDAT", Deflate(Bytes({0, 0x34}))), PngChunk("IEND", "")}));
  ASSERT_TRUE(grey.ok());
  const auto& bytes = std::get<ByteImage>(grey->pixels);
  ASSERT_EQ(bytes.Channels(), 2);
  EXPECT_EQ(bytes.At(0, 0, 0), 51);
  EXPECT_EQ(bytes.At(0, 0, 1), 0);
  EXPECT_EQ(bytes.At(1, 0, 1), 255);

  const Result<PngImage> colour =
      DecodePng(PngFile({PngHeader(2, 1, 16, 2), PngChunk("tRNS", Bytes({1, 2, 3, 4, 5, 6})),
                         PngChunk("IDAT", Deflate(Bytes({0, 1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 7}))),
                         PngChunk("IEND", "")}));
  ASSERT_TRUE(colour.ok());
  const auto& words = std::get<WordImage>(colour->pixels);
  ASSERT_EQ(words.Channels(), 4);
  EXPECT_EQ(words.At(0, 0, 1), 0x304);
  EXPECT_EQ(words.At(0, 0, 3), 0);
  EXPECT_EQ(words.At(1, 0, 3), 65535);
}

// The colour's number has 16 bits in the file; none of a pixel's 4 can equal one beyond 15.
TEST(PngFormats, TransparentColourBeyondTheDepthIsNoPixels) {
  const Result<PngImage> png =
      DecodePng(PngFile({PngHeader(2, 1, 4, 0), PngChunk("tRNS", Bytes({1, 3})),
                         PngChunk("IDAT", Deflate(Bytes({0, 0x34}))), PngChunk("IEND", "")}));
  ASSERT_TRUE(png.ok());
  const auto& image = std::get<ByteImage>(png->pixels);
  EXPECT_EQ(image.At(0, 0, 1), 255);
  EXPECT_EQ(image.At(1, 0, 1), 255);
}

TEST(PngFormats, FloatValuesAreFractionsOfTheLargest) {
  const Result<PngImage> png = DecodePng(PngOf(PngHeader(3, 1, 8, 0), Bytes({0, 0, 51, 255})));
  ASSERT_TRUE(png.ok());
  const Image image = png->ToFloat();
  EXPECT_EQ(image.At(0, 0), 0.0f);
  EXPECT_EQ(image.At(1, 0), 0.2f);
  EXPECT_EQ(image.At(2, 0), 1.0f);
}

// Every filter with every size of a pixel, above another row and without one.
TEST(PngFilters, AreUndoneForAllSizesOfAPixel) {
  for (const Format& format : kFormats) {
    if (format.depth < 8 || format.colour == 3) continue;
    const auto step = static_cast<size_t>(format.samples * format.depth / 8);
    for (int filter = 0; filter <= 4; ++filter) {
      std::string prior, row;
      for (size_t i = 0; i < 8 * step; ++i) {
        prior.push_back(static_cast<char>(i * 91 + 200));
        row.push_back(static_cast<char>(i * i * 7 + 3));
      }
      const Result<PngImage> png =
          DecodePng(PngOf(PngHeader(8, 2, format.depth, format.colour),
                          Filtered(filter, step, prior, std::string(8 * step, '\0')) +
                              Filtered(filter, step, row, prior)));
      ASSERT_TRUE(png.ok()) << png.error().message;
      std::string bytes;
      if (std::holds_alternative<WordImage>(png->pixels)) {
        for (const uint16_t word : std::get<WordImage>(png->pixels).Samples()) {
          bytes.push_back(static_cast<char>(word >> 8));
          bytes.push_back(static_cast<char>(word));
        }
      } else {
        for (const uint8_t byte : std::get<ByteImage>(png->pixels).Samples()) {
          bytes.push_back(static_cast<char>(byte));
        }
      }
      EXPECT_EQ(bytes, prior + row) << filter << " with " << step;
    }
  }
}

/// The predictor in the words of the standard.
int PaethByTheStandard(int a, int b, int c) {
  const int p = a + b - c;
  const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
  if (pa <= pb && pa <= pc) return a;
  return pb <= pc ? b : c;
}

// A second pixel of difference 0 is the prediction itself; the first one, whose left neighbours
// count as 0, is predicted by the one above it. The rows come in pairs: neighbours, prediction.
TEST(PngFilters, PaethPredictsTheNearestNeighbour) {
  for (int corner = 0; corner < 256; corner += 15) {
    std::string rows;
    for (int left = 0; left < 256; ++left) {
      for (int above = 0; above < 256; ++above) {
        rows += Bytes({0, corner, above, 4, left - corner, 0});
      }
    }
    const Result<PngImage> png = DecodePng(PngOf(PngHeader(2, 2 * 256 * 256, 8, 0), rows));
    ASSERT_TRUE(png.ok()) << png.error().message;
    const auto& image = std::get<ByteImage>(png->pixels);
    for (int left = 0; left < 256; ++left) {
      for (int above = 0; above < 256; ++above) {
        ASSERT_EQ(image.At(1, 2 * (256 * left + above) + 1),
                  PaethByTheStandard(left, above, corner))
            << left << " " << above << " " << corner;
      }
    }
  }
}

}  // namespace
}  // namespace candela
