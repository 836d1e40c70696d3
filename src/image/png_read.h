#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "image/raster.h"
#include "image/size_limit.h"

namespace candela {

/// The pixels of a PNG file: bytes for files of 1 to 8 bits per sample (fewer than 8 are spread
/// over 0..255), words for 16 bits. One to four channels; a palette becomes colours; a transparent
/// colour or a palette with transparent entries becomes alpha.
struct PngImage {
  std::variant<ByteImage, WordImage> pixels;

  int Width() const;
  int Height() const;
  int Channels() const;

  /// Values from 0 to 1; no gamma.
  Image ToFloat() const;
};

/// Reads a PNG file of any colour type, depth and interlacing. Colour profiles and gamma are not
/// applied.
///
/// Errors: a wrong checksum of a critical chunk or of the compressed data, too little data, a bad
/// filter, depth, colour type, chunk length or order, a palette that is missing or too short for an
/// index, a picture of more than `most_bytes`. Warnings: surplus data, a missing end, a
/// transparency that does not fit. `warnings` may be null. Takes memory for pixels only if the data
/// is long enough to hold them.
Result<PngImage> DecodePng(std::string_view bytes, std::vector<std::string>* warnings = nullptr,
                           int64_t most_bytes = kMostImageBytes);

}  // namespace candela
