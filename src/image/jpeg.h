#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/raster.h"
#include "image/size_limit.h"

namespace candela {

/// What every JPEG file begins with.
inline constexpr std::string_view kJpegSignature = "\xff\xd8\xff";

/// Pixels on each side that a JPEG file can have, by the limit of the library.
inline constexpr int kMostJpegSide = 65500;

/// Reads a JPEG file, baseline or progressive, of 8 bits: one channel of grey, or red, green and
/// blue. Colour profiles and the turns that cameras note down are not applied.
///
/// Errors: data that is damaged or cut off anywhere, four inks (CMYK), 12 bits, lossless coding, a
/// side of more than `kMostJpegSide`, a picture that takes more than `most_bytes` while it is
/// decoded. Takes memory for pixels only after the size has been judged.
Result<ByteImage> DecodeJpeg(std::string_view bytes, int64_t most_bytes = kMostImageBytes);

/// The bytes of a baseline JPEG file of quality 95, without subsampling of colours: of one channel
/// or three, up to `kMostJpegSide` on each side. The same pixels always give the same bytes.
Result<std::string> EncodeJpeg(const ByteImage& image);

}  // namespace candela
