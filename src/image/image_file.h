#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/exr.h"
#include "image/raster.h"
#include "image/size_limit.h"
#include "image/tone_curve.h"

namespace candela {

enum class ImageFormat { kPng, kJpeg, kExr, kHdr, kPfm };

/// Whether files of this format hold what a display shows, from 0 to 1, instead of light.
constexpr bool IsForDisplays(ImageFormat format) {
  return format == ImageFormat::kPng || format == ImageFormat::kJpeg;
}

/// The format that a file name asks for by its extension (png, jpg or jpeg, exr, hdr, pfm;
/// case does not matter).
std::optional<ImageFormat> FormatOf(const std::filesystem::path& path);

/// The format that the first bytes show, whatever the name.
std::optional<ImageFormat> FormatOfContent(std::string_view bytes);

/// Reads a picture of any of these formats. PNG and JPEG samples become values from 0 to 1, without
/// gamma; the others hold floats. Warnings and errors are those of the decoder.
Result<Image> DecodeImage(std::string_view bytes, std::vector<std::string>* warnings = nullptr,
                          int64_t most_bytes = kMostImageBytes);

/// The same for a file. The message of an error does not repeat the path.
Result<Image> ReadImage(const std::filesystem::path& path,
                        std::vector<std::string>* warnings = nullptr,
                        int64_t most_bytes = kMostImageBytes);

struct EncodeOptions {
  int png_bits = 8;  ///< 8 (the course's plain clamp) or 16 (rounded); see quantise.h.
  /// For PNG and JPEG pictures of colours. With a curve 8 bits are rounded, too.
  ToneMapping tone;
  std::vector<ExrAttribute> attributes;  ///< For EXR.
};

/// The bytes of a file for 1 to 4 channels. PNG and JPEG clamp to 0..1; EXR, HDR and PFM hold
/// values as they are; JPEG, HDR and PFM are without alpha. `WriteFileAtomically` puts them on
/// disk.
Result<std::string> EncodeImage(const Image& image, ImageFormat format,
                                const EncodeOptions& options = {});

}  // namespace candela
