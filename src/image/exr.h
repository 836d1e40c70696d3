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

/// A channel to be written: 32-bit samples in rows from the top, somewhere in memory.
struct ExrChannel {
  std::string name;
  bool is_whole;  ///< The samples are `uint32_t`, not float.
  const void* samples;
  int stride;  ///< Samples from one pixel to the next.
};

/// A text that says something about the picture.
struct ExrAttribute {
  std::string name, value;
};

/// The bytes of a scanline file with ZIP compression. The names of channels differ from each other,
/// as do those of attributes.
Result<std::string> EncodeExr(int width, int height, std::span<const ExrChannel> channels,
                              std::span<const ExrAttribute> attributes = {});

/// The same for floats: Y, YA, RGB or RGBA by the number of channels (1 to 4).
Result<std::string> EncodeExr(const Image& image, std::span<const ExrAttribute> attributes = {});

/// The same with a name for each channel.
Result<std::string> EncodeExr(const Image& image, std::span<const std::string> channels);

}  // namespace candela
