#include "image/png_chunks.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>

#include "base/text.h"
#include "image/big_endian.h"

namespace candela {
namespace {

constexpr size_t kMostLength = 0x7fffffff;

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

struct Chunk {
  std::string_view type;
  std::string_view content;
  std::string_view checked;  // type and content, what the checksum covers
  uint32_t checksum;

  bool IsCritical() const { return (type[0] & 0x20) == 0; }
  bool IsIntact() const { return libdeflate_crc32(0, checked.data(), checked.size()) == checksum; }
};

bool IsChunkType(std::string_view type) {
  return std::all_of(type.begin(), type.end(),
                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
}

/// Reads the chunk that `*rest` begins with and moves on. Length and type must be there.
Result<Chunk> TakeChunk(std::string_view* rest) {
  const size_t length = BigEndian32(rest->data());
  const std::string_view type = rest->substr(4, 4);
  if (!IsChunkType(type)) return Wrong(fmt::format("{} is not a chunk name", Quote(type)));
  if (length > kMostLength || rest->size() < 12 || length > rest->size() - 12) {
    return Wrong(fmt::format("the chunk {} claims {} bytes, but only {} are left in the file",
                             Quote(type), length, rest->size() - 8));
  }
  const Chunk chunk{type, rest->substr(8, length), rest->substr(4, length + 4),
                    BigEndian32(rest->data() + 8 + length)};
  rest->remove_prefix(length + 12);
  return chunk;
}

bool IsDepthAllowed(PngColour colour, int depth) {
  switch (colour) {
    case PngColour::kGrey:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
    case PngColour::kPalette:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8;
    case PngColour::kRgb:
    case PngColour::kGreyAlpha:
    case PngColour::kRgbAlpha:
      return depth == 8 || depth == 16;
  }
  return false;
}

Result<void> ReadHeader(std::string_view content, PngChunks* png) {
  if (content.size() != 13) {
    return Wrong(fmt::format("the chunk 'IHDR' has {} bytes instead of 13", content.size()));
  }
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(content[i]); };
  png->width = BigEndian32(content.data());
  png->height = BigEndian32(content.data() + 4);
  if (png->width - 1 >= kMostLength || png->height - 1 >= kMostLength) {
    return Wrong(
        fmt::format("a picture of {} x {} pixels is not possible", png->width, png->height));
  }
  const int colour = byte(9);
  if (colour != 0 && colour != 2 && colour != 3 && colour != 4 && colour != 6) {
    return Wrong(fmt::format("{} is not a colour type (0, 2, 3, 4 or 6)", colour));
  }
  png->colour = static_cast<PngColour>(colour);
  png->bit_depth = byte(8);
  if (!IsDepthAllowed(png->colour, png->bit_depth)) {
    return Wrong(
        fmt::format("a depth of {} bits does not go with colour type {}", png->bit_depth, colour));
  }
  if (byte(10) != 0) return Wrong(fmt::format("{} is not a compression method (0)", byte(10)));
  if (byte(11) != 0) return Wrong(fmt::format("{} is not a filter method (0)", byte(11)));
  if (byte(12) > 1) return Wrong(fmt::format("{} is not an interlace method (0 or 1)", byte(12)));
  png->interlaced = byte(12) == 1;
  return {};
}

Result<void> ReadPalette(std::string_view content, PngChunks* png) {
  if (!png->palette.empty()) return Wrong("the chunk 'PLTE' is given twice");
  if (!png->data.empty()) return Wrong("the chunk 'PLTE' comes after the picture data");
  const size_t most = png->colour == PngColour::kPalette ? size_t{3} << png->bit_depth : 768;
  if (content.empty() || content.size() % 3 != 0 || content.size() > most) {
    return Wrong(fmt::format("a palette of {} bytes is not possible (a multiple of 3, at most {})",
                             content.size(), most));
  }
  png->palette = content;
  return {};
}

/// Transparency is optional, so a table that does not fit the picture is left out, as libpng does.
void ReadTransparency(std::string_view content, PngChunks* png,
                      std::vector<std::string>* warnings) {
  bool fits = png->data.empty() && png->transparency.empty();
  switch (png->colour) {
    case PngColour::kGrey:
      fits = fits && content.size() == 2;
      break;
    case PngColour::kRgb:
      fits = fits && content.size() == 6;
      break;
    case PngColour::kPalette:
      fits = fits && !content.empty() && content.size() <= png->palette.size() / 3;
      break;
    case PngColour::kGreyAlpha:
    case PngColour::kRgbAlpha:
      fits = false;
      break;
  }
  if (fits) {
    png->transparency = content;
  } else if (warnings) {
    warnings->push_back("the chunk 'tRNS' does not fit the picture and is not used");
  }
}

}  // namespace

int PngChunks::StoredChannels() const {
  switch (colour) {
    case PngColour::kGrey:
    case PngColour::kPalette:
      return 1;
    case PngColour::kGreyAlpha:
      return 2;
    case PngColour::kRgb:
      return 3;
    case PngColour::kRgbAlpha:
      return 4;
  }
  return 1;
}

Result<PngChunks> ReadPngChunks(std::string_view bytes, std::vector<std::string>* warnings) {
  if (!bytes.starts_with(kPngSignature)) return Wrong("this is not a PNG file");
  const auto warn = [&](std::string text) {
    if (warnings) warnings->push_back(std::move(text));
  };
  PngChunks png;
  std::string_view rest = bytes.substr(kPngSignature.size());
  bool has_header = false, has_end = false, data_is_closed = false;

  // The end chunk has no content, so a file that stops inside it lacks only the end itself.
  while (rest.size() >= 8 && !(rest.size() < 12 && rest.substr(4, 4) == "IEND")) {
    const Result<Chunk> chunk = TakeChunk(&rest);
    if (!chunk) return chunk.error();
    const auto& [type, content, checked, checksum] = *chunk;
    if (chunk->IsCritical() && !chunk->IsIntact()) {
      return Wrong(fmt::format("the checksum of the chunk {} is wrong", Quote(type)));
    }
    if (has_header == (type == "IHDR")) {
      return Wrong(has_header ? "the chunk 'IHDR' is given twice"
                              : "the file does not begin with the chunk 'IHDR'");
    }
    if (type != "IDAT") data_is_closed = !png.data.empty();

    if (type == "IHDR") {
      if (Result<void> done = ReadHeader(content, &png); !done) return done.error();
      has_header = true;
    } else if (type == "PLTE") {
      if (Result<void> done = ReadPalette(content, &png); !done) return done.error();
    } else if (type == "tRNS") {
      ReadTransparency(content, &png, warnings);
    } else if (type == "IDAT") {
      if (data_is_closed) return Wrong("the 'IDAT' chunks do not follow each other");
      png.data.push_back(content);
    } else if (type == "IEND") {
      if (!content.empty()) return Wrong("the chunk 'IEND' is not empty");
      has_end = true;
      break;
    } else if (chunk->IsCritical()) {
      return Wrong(
          fmt::format("the chunk {} is not known, but needed to read the picture", Quote(type)));
    }
  }

  if (!has_header) return Wrong("the file ends before the chunk 'IHDR'");
  if (png.colour == PngColour::kPalette && png.palette.empty())
    return Wrong("the palette is missing");
  if (png.data.empty()) return Wrong("there is no picture data");
  if (!has_end) {
    warn("the end of the file is missing");
  } else if (!rest.empty()) {
    warn(fmt::format("{} bytes after the end of the picture are not used", rest.size()));
  }
  return png;
}

}  // namespace candela
