#include "image/image_file.h"

#include "base/files.h"
#include "image/channels.h"
#include "image/exr.h"
#include "image/hdr.h"
#include "image/jpeg.h"
#include "image/pfm.h"
#include "image/png_chunks.h"
#include "image/png_read.h"
#include "image/png_write.h"
#include "image/quantise.h"

namespace candela {

std::optional<ImageFormat> FormatOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (extension == ".png") return ImageFormat::kPng;
  if (extension == ".jpg" || extension == ".jpeg") return ImageFormat::kJpeg;
  if (extension == ".exr") return ImageFormat::kExr;
  if (extension == ".hdr") return ImageFormat::kHdr;
  if (extension == ".pfm") return ImageFormat::kPfm;
  return std::nullopt;
}

std::optional<ImageFormat> FormatOfContent(std::string_view bytes) {
  if (bytes.starts_with(kPngSignature)) return ImageFormat::kPng;
  if (bytes.starts_with(kJpegSignature)) return ImageFormat::kJpeg;
  if (bytes.starts_with("\x76\x2f\x31\x01")) return ImageFormat::kExr;
  if (bytes.starts_with("#?")) return ImageFormat::kHdr;
  if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return ImageFormat::kPfm;
  return std::nullopt;
}

Result<Image> DecodeImage(std::string_view bytes, std::vector<std::string>* warnings,
                          int64_t most_bytes) {
  const std::optional<ImageFormat> format = FormatOfContent(bytes);
  if (!format) return Error{ErrorCode::kInput, "this is not a PNG, JPEG, EXR, HDR or PFM picture"};
  switch (*format) {
    case ImageFormat::kPng: {
      const Result<PngImage> png = DecodePng(bytes, warnings, most_bytes);
      if (!png) return png.error();
      return png->ToFloat();
    }
    case ImageFormat::kJpeg: {
      const Result<ByteImage> jpeg = DecodeJpeg(bytes, most_bytes);
      if (!jpeg) return jpeg.error();
      return ToFloat(*jpeg);
    }
    case ImageFormat::kExr:
      return DecodeExr(bytes, most_bytes);
    case ImageFormat::kHdr:
      return DecodeHdr(bytes, warnings, most_bytes);
    case ImageFormat::kPfm:
      return DecodePfm(bytes, warnings, most_bytes);
  }
  CHECK(false);
  return Image();
}

Result<Image> ReadImage(const std::filesystem::path& path, std::vector<std::string>* warnings,
                        int64_t most_bytes) {
  const Result<std::string> bytes = ReadFile(path);
  if (!bytes) return bytes.error();
  return DecodeImage(*bytes, warnings, most_bytes);
}

namespace {

/// What a display shall show; other channels than three are not colours.
Image Toned(const Image& image, const ToneMapping& tone) {
  Image toned = image;
  if (image.Channels() != 3) return toned;
  const auto samples = toned.Samples();
  for (size_t i = 0; i < samples.size(); i += 3) {
    const Rgb c = tone.Encode({samples[i], samples[i + 1], samples[i + 2]});
    samples[i] = c.x, samples[i + 1] = c.y, samples[i + 2] = c.z;
  }
  return toned;
}

Result<std::string> EncodeAsPng(const Image& image, const EncodeOptions& options) {
  if (options.png_bits == 16) {
    return EncodePng(QuantiseToWords(options.tone.curve ? Toned(image, options.tone) : image));
  }
  if (!options.tone.curve) return EncodePng(QuantiseToBytes(image));
  return EncodePng(RoundToBytes(Toned(image, options.tone)));
}

Result<std::string> EncodeAsJpeg(const Image& image, const EncodeOptions& options) {
  const Image opaque = WithChannels(image, image.Channels() < 3 ? 1 : 3);
  if (!options.tone.curve) return EncodeJpeg(QuantiseToBytes(opaque));
  return EncodeJpeg(RoundToBytes(Toned(opaque, options.tone)));
}

}  // namespace

Result<std::string> EncodeImage(const Image& image, ImageFormat format,
                                const EncodeOptions& options) {
  CHECK(options.png_bits == 8 || options.png_bits == 16);
  switch (format) {
    case ImageFormat::kPng:
      return EncodeAsPng(image, options);
    case ImageFormat::kJpeg:
      return EncodeAsJpeg(image, options);
    case ImageFormat::kExr:
      return EncodeExr(image, options.attributes);
    case ImageFormat::kHdr:
      return EncodeHdr(image);
    case ImageFormat::kPfm:
      return EncodePfm(image);
  }
  CHECK(false);
  return std::string();
}

}  // namespace candela
