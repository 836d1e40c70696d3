// Why the chunks are not left to libspng: it takes a second palette, a transparency that does not
// fit and bytes after the end in silence, tells a missing end or scattered data only to those who
// ask for the chunks behind the pixels, and unpacks texts and profiles that nobody wants.
#include "image/png_chunks.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <memory>

#include "base/text.h"

namespace candela {
namespace {

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

uint32_t BigEndian32(const char* bytes) {
  uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
  return value;
}

struct Chunk {
  std::string_view type, content;
  bool is_intact;  // True for ancillary chunks, whose checksums are not looked at.

  bool IsCritical() const { return (type[0] & 0x20) == 0; }
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
  if (length > 0x7fffffff || rest->size() < 12 || length > rest->size() - 12) {
    return Wrong(fmt::format("the chunk {} claims {} bytes, but only {} are left in the file",
                             Quote(type), length, rest->size() - 8));
  }
  Chunk chunk{type, rest->substr(8, length), true};
  if (chunk.IsCritical()) {
    const auto* checked = reinterpret_cast<const Bytef*>(type.data());
    chunk.is_intact = crc32_z(0, checked, length + 4) == BigEndian32(rest->data() + 8 + length);
  }
  rest->remove_prefix(length + 12);
  return chunk;
}

/// The header as the library reads it, with all its checks.
Result<spng_ihdr> ReadHeader(std::string_view bytes) {
  const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), &spng_ctx_free);
  spng_ihdr header;
  spng_set_png_buffer(context.get(), bytes.data(), bytes.size());
  const int code = spng_get_ihdr(context.get(), &header);
  if (code == SPNG_EOVERFLOW) {  // More than 32 bits count.
    return Error{ErrorCode::kResources, "the rows of the picture are too long"};
  }
  if (code != SPNG_OK) {
    return Wrong(fmt::format("the header is wrong: {}", spng_strerror(code)));
  }
  return header;
}

Result<void> ReadPalette(std::string_view content, PngChunks* png) {
  if (!png->palette.empty()) return Wrong("the chunk 'PLTE' is given twice");
  if (!png->data.empty()) return Wrong("the chunk 'PLTE' comes after the picture data");
  const size_t most = png->IsIndexed() ? size_t{3} << png->header.bit_depth : 768;
  if (content.empty() || content.size() % 3 != 0 || content.size() > most) {
    return Wrong(fmt::format("a palette of {} bytes is not possible (a multiple of 3, at most {})",
                             content.size(), most));
  }
  png->palette = content;
  return {};
}

bool TransparencyFits(std::string_view content, const PngChunks& png) {
  if (!png.data.empty() || !png.transparency.empty()) return false;
  if (png.IsIndexed()) return !content.empty() && content.size() <= png.palette.size() / 3;
  const int channels = png.StoredChannels();
  return channels % 2 == 1 && content.size() == 2 * static_cast<size_t>(channels);
}

}  // namespace

Result<PngChunks> ReadPngChunks(std::string_view bytes, std::vector<std::string>* warnings) {
  if (!bytes.starts_with(kPngSignature)) return Wrong("this is not a PNG file");
  const auto warn = [&](std::string text) {
    if (warnings) warnings->push_back(std::move(text));
  };
  const Result<spng_ihdr> header = ReadHeader(bytes);
  if (!header) return header.error();
  PngChunks png;
  png.header = *header;
  std::string_view rest = bytes.substr(kPngSignature.size());
  bool has_header = false, has_end = false, data_is_closed = false;

  // The end chunk has no content, so a file that stops inside it lacks only the end itself.
  while (!has_end && rest.size() >= 8 && !(rest.size() < 12 && rest.substr(4, 4) == "IEND")) {
    const Result<Chunk> chunk = TakeChunk(&rest);
    if (!chunk) return chunk.error();
    const std::string_view type = chunk->type;
    if (!chunk->is_intact) {
      return Wrong(fmt::format("the checksum of the chunk {} is wrong", Quote(type)));
    }
    if (type != "IDAT") data_is_closed = !png.data.empty();

    if (type == "IHDR") {
      if (has_header) return Wrong("the chunk 'IHDR' is given twice");
      has_header = true;
    } else if (type == "PLTE") {
      if (Result<void> done = ReadPalette(chunk->content, &png); !done) return done.error();
    } else if (type == "tRNS") {
      // Transparency is optional, so a table that does not fit the picture is left out.
      if (TransparencyFits(chunk->content, png)) {
        png.transparency = chunk->content;
      } else {
        warn("the chunk 'tRNS' does not fit the picture and is not used");
      }
    } else if (type == "IDAT") {
      if (data_is_closed) return Wrong("the 'IDAT' chunks do not follow each other");
      png.data.push_back(chunk->content);
    } else if (type == "IEND") {
      if (!chunk->content.empty()) return Wrong("the chunk 'IEND' is not empty");
      has_end = true;
    } else if (chunk->IsCritical()) {
      return Wrong(
          fmt::format("the chunk {} is not known, but needed to read the picture", Quote(type)));
    }
  }

  if (png.IsIndexed() && png.palette.empty()) return Wrong("the palette is missing");
  if (png.data.empty()) return Wrong("there is no picture data");
  if (!has_end) {
    warn("the end of the file is missing");
  } else if (!rest.empty()) {
    warn(fmt::format("{} bytes after the end of the picture are not used", rest.size()));
  }
  return png;
}

}  // namespace candela
