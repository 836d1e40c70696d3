#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace candela {

/// Colour types as the file numbers them.
enum class PngColour : uint8_t { kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgbAlpha = 6 };

/// The outer form of a PNG file: its header and the contents of the chunks that pixels depend on.
/// The views point into the bytes of the file.
struct PngChunks {
  uint32_t width = 0;   ///< From 1 to 2^31 - 1.
  uint32_t height = 0;  ///< From 1 to 2^31 - 1.
  int bit_depth = 0;    ///< Per sample: 1, 2, 4, 8 or 16, as the colour type allows.
  PngColour colour = PngColour::kGrey;
  bool interlaced = false;
  std::string_view palette;  ///< Three bytes per entry; present if the colour type needs it.
  std::string_view
      transparency;  ///< tRNS: an alpha per entry, or one transparent colour; or empty.
  std::vector<std::string_view> data;  ///< IDAT, in order: one compressed stream cut into pieces.

  /// Samples per pixel as stored: 1 for a palette index.
  int StoredChannels() const;
};

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);

/// Takes a file apart and checks each chunk: length, order, and the checksum where the chunk is
/// critical. The checksum of an ancillary chunk is not looked at. Bytes after the end and a missing
/// end are warnings. Whether the data is complete is for `DecodePng` to find.
Result<PngChunks> ReadPngChunks(std::string_view bytes, std::vector<std::string>* warnings);

}  // namespace candela
