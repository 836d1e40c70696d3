#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>

#include "image/jpeg.h"

namespace candela {
namespace {

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

// The exact transform, whose vector code gives the same bytes as the plain one. What the library
// only warns of, data that is cut off or damaged, ends its work. And it goes over the picture at
// most 500 times, where a small progressive file may ask for any number.
constexpr int kFlags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;

/// Why the library has given up.
Error ErrorOf(const Decoder& decoder) {
  const std::string_view text = tjGetErrorStr2(decoder.get());
  const size_t function = text.find("(): ");  // Some texts begin with the name of a function.
  const std::string_view reason = function == text.npos ? text : text.substr(function + 4);
  return {ErrorCode::kInput, fmt::format("the picture cannot be decoded: {}", reason)};
}

}  // namespace

Result<ByteImage> DecodeJpeg(std::string_view bytes, int64_t most_bytes) {
  if (!bytes.starts_with(kJpegSignature)) {
    return Error{ErrorCode::kInput, "this is not a JPEG picture"};
  }
  const Decoder decoder(tjInitDecompress(), &tjDestroy);
  if (!decoder) return Error{ErrorCode::kResources, "no memory for a JPEG decoder"};
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0, height = 0, subsampling = 0, colours = 0;
  if (tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling,
                          &colours) != 0) {
    return ErrorOf(decoder);
  }
  if (colours == TJCS_CMYK || colours == TJCS_YCCK) {
    return Error{ErrorCode::kInput,
                 "colours of four inks (CMYK) are not known, only red, green "
                 "and blue, and grey"};
  }
  const int channels = colours == TJCS_GRAY ? 1 : 3;
  // Beside the bytes the decoder keeps coefficients of 16 bits when the file is progressive.
  constexpr int kBytesPerSample = 3;
  const auto fits = CheckImageSize(width, height, kBytesPerSample * channels, most_bytes);
  if (!fits) return fits.error();
  ByteImage image(width, height, channels);
  if (tjDecompress2(decoder.get(), data, bytes.size(), image.Samples().data(), width, 0, height,
                    channels == 1 ? TJPF_GRAY : TJPF_RGB, kFlags) != 0) {
    return ErrorOf(decoder);
  }
  return image;
}

}  // namespace candela
