#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/raster.h"
#include "image/size_limit.h"

namespace candela {

/// A picture whose channels have names, such as "R", "albedo.G" or "Z".
struct ExrPicture {
  Image image;                        ///< As many channels as names.
  std::vector<std::string> channels;  ///< In alphabetical order, as such files hold them.
};

/// The colours of an OpenEXR file: R, G, B (and A), else Y (and A), else its only channel.
/// Scanlines or tiles, of several parts the first, of several levels the largest; the picture is
/// the data window. Half, float and whole numbers become float. The lossy compressions DWAA and
/// DWAB, deep pixels, subsampled channels and files that lack a block are errors, as is a picture
/// of more than `most_bytes`.
Result<Image> DecodeExr(std::string_view bytes, int64_t most_bytes = kMostImageBytes);

/// All channels of such a file.
Result<ExrPicture> DecodeExrChannels(std::string_view bytes, int64_t most_bytes = kMostImageBytes);

/// The bytes of a scanline file with 32-bit floats and ZIP compression: Y, YA, RGB or RGBA by the
/// number of channels (1 to 4).
Result<std::string> EncodeExr(const Image& image);

/// The same with a name for each channel; the names differ from each other.
Result<std::string> EncodeExr(const Image& image, std::span<const std::string> channels);

}  // namespace candela
