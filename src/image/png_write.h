#pragma once

#include <string>

#include "base/result.h"
#include "image/raster.h"

namespace candela {

/// How long the encoder may look for a smaller file; the pixels are the same.
enum class PngEffort {
  kFast,   ///< For pictures just rendered: 2 to 8 ns per sample.
  kSmall,  ///< For pictures kept for long: 7 to 100 times slower, a tenth to a half smaller.
};

/// The bytes of a PNG file with 8 or 16 bits per sample; 1 to 4 channels as `ByteImage` says. No
/// colour profile. The same pixels always give the same bytes.
Result<std::string> EncodePng(const ByteImage& image, PngEffort effort = PngEffort::kFast);
Result<std::string> EncodePng(const WordImage& image, PngEffort effort = PngEffort::kFast);

}  // namespace candela
