#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "base/result.h"
#include "image/raster.h"

struct spng_ctx;

namespace candela {

/// How long the encoder may look for a smaller file; the pixels are the same.
enum class PngEffort {
  kFast,   ///< For pictures just rendered: 2 to 8 ns per sample.
  kSmall,  ///< For pictures kept for long: 7 to 100 times slower, a tenth to a half smaller.
};

/// Encodes a picture row by row, so that it can begin while the last rows are still being made.
class PngRowEncoder {
 public:
  /// 1 to 4 channels as `ByteImage` says, of 8 or 16 bits.
  PngRowEncoder(int width, int height, int channels, int bits, PngEffort effort);

  /// The next row from the top; 16-bit samples in the order of this machine.
  void Add(std::span<const std::byte> row);

  /// The bytes of the file, once after the last row.
  Result<std::string> Finish();

 private:
  std::unique_ptr<std::string> file_;  ///< At an address that stays, for the library.
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
  int status_;  ///< The library's first error, or its word that all rows are there.
};

/// The bytes of a PNG file with 8 or 16 bits per sample; 1 to 4 channels as `ByteImage` says. No
/// colour profile. The same pixels always give the same bytes.
Result<std::string> EncodePng(const ByteImage& image, PngEffort effort = PngEffort::kFast);
Result<std::string> EncodePng(const WordImage& image, PngEffort effort = PngEffort::kFast);

}  // namespace candela
