// What a PNG file may do wrong, and what is said about it (docs of input rules: PNG).
#include <gmock/gmock.h>

#include "image/png_read.h"
#include "tests/image/png_builder.h"

namespace candela {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kHeader = PngHeader(2, 2, 8, 0);
const std::string kScanlines = Bytes({0, 10, 20, 0, 30, 40});
const std::string kData = PngChunk("IDAT", Deflate(kScanlines));
const std::string kEnd = PngChunk("IEND", "");

std::string ErrorOf(const std::string& file) {
  const Result<PngImage> result = DecodePng(file);
  return result.ok() ? "no error" : result.error().message;
}

/// Warnings of a file that must still give the picture 10 20 / 30 40.
std::vector<std::string> WarningsOf(const std::string& file) {
  std::vector<std::string> warnings;
  const Result<PngImage> result = DecodePng(file, &warnings);
  if (!result.ok()) return {"error: " + result.error().message};
  const auto& image = std::get<ByteImage>(result->pixels);
  EXPECT_EQ(image.At(0, 0), 10);
  EXPECT_EQ(image.At(1, 0), 20);
  EXPECT_EQ(image.At(0, 1), 30);
  EXPECT_EQ(image.At(1, 1), 40);
  return warnings;
}

/// The chunk with its last checksum byte changed.
std::string Damaged(std::string chunk) {
  chunk.back() = static_cast<char>(chunk.back() ^ 1);
  return chunk;
}

TEST(PngRules, ASoundFileGivesNoWarning) {
  EXPECT_THAT(WarningsOf(PngFile({kHeader, kData, kEnd})), IsEmpty());
}

TEST(PngRules, DataMayBeCutIntoPieces) {
  const std::string stream = Deflate(kScanlines);
  EXPECT_THAT(WarningsOf(PngFile({kHeader, PngChunk("IDAT", stream.substr(0, 3)),
                                  PngChunk("IDAT", ""), PngChunk("IDAT", stream.substr(3)), kEnd})),
              IsEmpty());
}

TEST(PngRules, WrongChecksumOfACriticalChunkIsAnError) {
  EXPECT_EQ(ErrorOf(PngFile({Damaged(kHeader), kData, kEnd})),
            "the checksum of the chunk 'IHDR' is wrong");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, Damaged(kData), kEnd})),
            "the checksum of the chunk 'IDAT' is wrong");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, kData, Damaged(kEnd)})),
            "the checksum of the chunk 'IEND' is wrong");
  EXPECT_EQ(
      ErrorOf(PngFile({PngHeader(2, 2, 8, 3), Damaged(PngChunk("PLTE", "abc")), kData, kEnd})),
      "the checksum of the chunk 'PLTE' is wrong");
}

TEST(PngRules, WrongChecksumOfThePixelsIsAnError) {
  std::string stream = Deflate(kScanlines);
  stream.back() = static_cast<char>(stream.back() ^ 1);
  EXPECT_EQ(ErrorOf(PngFile({kHeader, PngChunk("IDAT", stream), kEnd})),
            "the picture data is damaged or cut off");
}

// All pixels are there, but nothing says that they are right.
TEST(PngRules, MissingChecksumOfThePixelsIsAnError) {
  const std::string stream = Deflate(kScanlines);
  for (size_t cut = 1; cut <= 4; ++cut) {
    EXPECT_EQ(
        ErrorOf(PngFile({kHeader, PngChunk("IDAT", stream.substr(0, stream.size() - cut)), kEnd})),
        "the picture data is damaged or cut off");
  }
}

// A profile that does not unpack, a gamma without a value, a text without an end.
TEST(PngRules, FaultsOfAncillaryChunksAreIgnored) {
  EXPECT_THAT(WarningsOf(PngFile({kHeader, PngChunk("iCCP", Bytes({'a', 0, 0, 1, 2, 3, 4})),
                                  PngChunk("gAMA", ""), PngChunk("zTXt", "x"), kData, kEnd})),
              IsEmpty());
}

TEST(PngRules, ChecksumOfAnAncillaryChunkIsNotLookedAt) {
  EXPECT_THAT(WarningsOf(PngFile({kHeader, Damaged(PngChunk("tEXt", "a\0b")), kData,
                                  Damaged(PngChunk("tIME", "1234567")), kEnd})),
              IsEmpty());
}

TEST(PngRules, TooLittleDataIsAnError) {
  EXPECT_EQ(ErrorOf(PngOf(kHeader, kScanlines.substr(0, 5))),
            "there is too little data: 5 of 6 bytes");
  const std::string stream = Deflate(kScanlines);
  EXPECT_EQ(
      ErrorOf(PngFile({kHeader, PngChunk("IDAT", stream.substr(0, stream.size() - 5)), kEnd})),
      "the picture data is damaged or cut off");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, PngChunk("IDAT", ""), kEnd})),
            "the picture data is damaged or cut off");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, kEnd})), "there is no picture data");
  EXPECT_EQ(ErrorOf(PngFile({kHeader})), "there is no picture data");
  EXPECT_EQ(ErrorOf(PngFile({})), "the header is wrong: end of stream");
}

TEST(PngRules, HeaderThatPromisesMoreThanTheFileCanHoldIsAnErrorBeforeMemoryIsTaken) {
  EXPECT_EQ(ErrorOf(PngFile({PngHeader(40000, 40000, 8, 0), kData, kEnd})),
            "there is too little data for a picture of this size");
  EXPECT_EQ(ErrorOf(PngFile({PngHeader(1 << 20, 0x7fffffff, 16, 6), kData, kEnd})),
            "a picture of 1048576 x 2147483647 pixels with 8 bytes each is beyond the limit of "
            "2147483648 bytes");
  const Result<PngImage> widest =
      DecodePng(PngFile({PngHeader(0x7fffffff, 0x7fffffff, 16, 6), kData, kEnd}));
  ASSERT_FALSE(widest.ok());
  EXPECT_EQ(widest.error().message, "the rows of the picture are too long");
  EXPECT_EQ(widest.error().code, ErrorCode::kResources);
}

TEST(PngRules, LimitOfMemoryIsALackOfResources) {
  const std::string file = PngFile({kHeader, kData, kEnd});
  EXPECT_TRUE(DecodePng(file, nullptr, 4).ok());
  const Result<PngImage> result = DecodePng(file, nullptr, 3);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kResources);
}

TEST(PngRules, BadFilterIsAnError) {
  EXPECT_EQ(ErrorOf(PngOf(kHeader, Bytes({0, 10, 20, 5, 30, 40}))),
            "the pixels are wrong: invalid scanline filter");
}

TEST(PngRules, BadHeaderIsAnError) {
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(0, 2, 8, 0), "")), "the header is wrong: invalid image width");
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(2, 0x80000000, 8, 0), "")),
            "the header is wrong: invalid image height");
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(2, 2, 8, 1), "")), "the header is wrong: invalid color type");
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(2, 2, 3, 0), "")), "the header is wrong: invalid bit depth");
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(2, 2, 16, 3), "")), "the header is wrong: invalid bit depth");
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(2, 2, 4, 2), "")), "the header is wrong: invalid bit depth");
  EXPECT_EQ(ErrorOf(PngOf(PngHeader(2, 2, 8, 0, 2), "")),
            "the header is wrong: invalid interlace method");
  const std::string size = Bytes({0, 0, 0, 2, 0, 0, 0, 2});
  EXPECT_EQ(ErrorOf(PngFile({PngChunk("IHDR", size + Bytes({8, 0, 1, 0, 0})), kData, kEnd})),
            "the header is wrong: invalid compression method");
  EXPECT_EQ(ErrorOf(PngFile({PngChunk("IHDR", size + Bytes({8, 0, 0, 7, 0})), kData, kEnd})),
            "the header is wrong: invalid filter method");
  EXPECT_EQ(ErrorOf(PngFile({PngChunk("IHDR", "short"), kData, kEnd})),
            "the header is wrong: invalid IHDR chunk size");
}

TEST(PngRules, BadChunkLengthIsAnError) {
  std::string text = PngChunk("tEXt", "abc");
  text[0] = 0x7f;
  EXPECT_EQ(ErrorOf(PngFile({kHeader, text, kData, kEnd})),
            "the chunk 'tEXt' claims 2130706435 bytes, but only 45 are left in the file");
  text[0] = static_cast<char>(0xff);
  EXPECT_EQ(ErrorOf(PngFile({kHeader, text, kData, kEnd})),
            "the chunk 'tEXt' claims 4278190083 bytes, but only 45 are left in the file");
}

TEST(PngRules, ChunksOutOfOrderAreErrors) {
  EXPECT_EQ(ErrorOf(PngFile({kData, kHeader, kEnd})),
            "the header is wrong: invalid IHDR chunk size");
  EXPECT_EQ(ErrorOf(PngFile({PngChunk("TEXT", "13 bytes long"), kHeader, kData, kEnd})),
            "the header is wrong: missing IHDR chunk");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, kHeader, kData, kEnd})), "the chunk 'IHDR' is given twice");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, kData, PngChunk("tEXt", "a"), kData, kEnd})),
            "the 'IDAT' chunks do not follow each other");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, kData, PngChunk("IEND", "x")})),
            "the chunk 'IEND' is not empty");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, PngChunk("NEED", ""), kData, kEnd})),
            "the chunk 'NEED' is not known, but needed to read the picture");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, PngChunk("\033[2J", ""), kData, kEnd})),
            "'\\x1b[2J' is not a chunk name");
}

TEST(PngRules, PaletteMustBeThereAndHoldEveryIndex) {
  const std::string header = PngHeader(2, 2, 8, 3);
  const std::string data = PngChunk("IDAT", Deflate(Bytes({0, 0, 1, 0, 1, 2})));
  EXPECT_EQ(ErrorOf(PngFile({header, data, kEnd})), "the palette is missing");
  EXPECT_EQ(ErrorOf(PngFile({header, PngChunk("PLTE", "aaabbb"), data, kEnd})),
            "a pixel in row 1 has a colour number beyond the 2 of the palette");
  EXPECT_EQ(ErrorOf(PngFile({header, PngChunk("PLTE", "aaabbbccc"), data, kEnd})), "no error");
  EXPECT_EQ(ErrorOf(PngFile({header, PngChunk("PLTE", "aaabbbcc"), data, kEnd})),
            "a palette of 8 bytes is not possible (a multiple of 3, at most 768)");
  EXPECT_EQ(ErrorOf(PngFile({header, PngChunk("PLTE", ""), data, kEnd})),
            "a palette of 0 bytes is not possible (a multiple of 3, at most 768)");
  EXPECT_EQ(ErrorOf(PngFile({PngHeader(2, 2, 1, 3), PngChunk("PLTE", "aaabbbccc"), data, kEnd})),
            "a palette of 9 bytes is not possible (a multiple of 3, at most 6)");
  EXPECT_EQ(ErrorOf(PngFile(
                {header, PngChunk("PLTE", "aaabbbccc"), PngChunk("PLTE", "abc"), data, kEnd})),
            "the chunk 'PLTE' is given twice");
  EXPECT_EQ(ErrorOf(PngFile({kHeader, kData, PngChunk("PLTE", "abc"), kEnd})),
            "the chunk 'PLTE' comes after the picture data");
}

TEST(PngRules, SurplusDataIsAWarning) {
  EXPECT_THAT(WarningsOf(PngOf(kHeader, kScanlines + "more")),
              ElementsAre("there is more data than the picture needs"));
  EXPECT_THAT(WarningsOf(PngFile({kHeader, PngChunk("IDAT", Deflate(kScanlines) + "x"), kEnd})),
              ElementsAre("there is more data than the picture needs"));
  EXPECT_THAT(WarningsOf(PngFile({kHeader, kData, PngChunk("IDAT", "x"), kEnd})),
              ElementsAre("there is more data than the picture needs"));
  EXPECT_THAT(WarningsOf(PngFile({kHeader, kData, kEnd, "tail"})),
              ElementsAre("4 bytes after the end of the picture are not used"));
}

// 64 MiB of zeros behind the pixels take 64 kB in the file; nothing of it is produced.
TEST(PngRules, DecompressionBombIsSurplusData) {
  EXPECT_THAT(WarningsOf(PngOf(kHeader, kScanlines + std::string(64 << 20, '\0'))),
              ElementsAre("there is more data than the picture needs"));
}

TEST(PngRules, MissingEndIsAWarningWhenAllPixelsAreThere) {
  for (size_t size = 0; size < kEnd.size(); ++size) {
    EXPECT_THAT(WarningsOf(PngFile({kHeader, kData, kEnd.substr(0, size)})),
                ElementsAre("the end of the file is missing"))
        << size;
  }
}

TEST(PngRules, TransparencyThatDoesNotFitIsLeftOut) {
  EXPECT_THAT(WarningsOf(PngFile({kHeader, PngChunk("tRNS", "abc"), kData, kEnd})),
              ElementsAre("the chunk 'tRNS' does not fit the picture and is not used"));
}

TEST(PngRules, AFileCutAnywhereIsAnErrorOrLacksItsEnd) {
  const std::string file = PngFile({PngHeader(2, 2, 8, 3), PngChunk("PLTE", "aaabbbccc"),
                                    PngChunk("tRNS", "\x80"), PngChunk("tEXt", "hello"),
                                    PngChunk("IDAT", Deflate(Bytes({0, 0, 1, 0, 1, 2}))), kEnd});
  for (size_t size = 0; size < file.size(); ++size) {
    // The end of the data chunk is where the end chunk begins.
    EXPECT_EQ(DecodePng(file.substr(0, size)).ok(), size >= file.size() - kEnd.size()) << size;
  }
}

TEST(PngRules, AnyChangedByteIsHandled) {
  const std::string file = PngFile({PngHeader(3, 5, 2, 3, 1), PngChunk("PLTE", "aaabbbccc"),
                                    PngChunk("IDAT", Deflate(std::string(40, '\1'))), kEnd});
  for (size_t i = 0; i < file.size(); ++i) {
    for (const int change : {1, 0x20, 0x80, 0xff}) {
      std::string changed = file;
      changed[i] = static_cast<char>(changed[i] ^ change);
      std::vector<std::string> warnings;
      const Result<PngImage> result = DecodePng(changed, &warnings, 1 << 20);
      if (!result.ok()) {
        EXPECT_FALSE(result.error().message.empty());
      }
    }
  }
}

}  // namespace
}  // namespace candela
