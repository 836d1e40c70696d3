#pragma once

#include <spng.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace candela {

/// The outer form of a PNG file: its header and the contents of the chunks that pixels depend on.
/// The views point into the bytes of the file.
struct PngChunks {
  spng_ihdr header{};             ///< Found sound by the library.
  std::string_view palette;       ///< Three bytes per entry; present if the colour type needs it.
  std::string_view transparency;  ///< tRNS: an alpha per entry, or one colour; or empty.
  std::vector<std::string_view> data;  ///< IDAT, in order: one compressed stream cut into pieces.

  bool IsIndexed() const { return header.color_type == SPNG_COLOR_TYPE_INDEXED; }
  /// Samples per pixel as stored: 1 for a palette index.
  int StoredChannels() const {
    constexpr int kByColourType[] = {1, 0, 3, 1, 2, 0, 4};
    return kByColourType[header.color_type];
  }
};

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);

/// Takes a file apart and checks each chunk: length, order, and the checksum where the chunk is
/// critical. The checksum of an ancillary chunk is not looked at. Bytes after the end and a missing
/// end are warnings. Whether the data is complete is for `DecodePng` to find.
Result<PngChunks> ReadPngChunks(std::string_view bytes, std::vector<std::string>* warnings);

}  // namespace candela
