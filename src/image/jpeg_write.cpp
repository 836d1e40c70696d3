#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>

#include "image/jpeg.h"

namespace candela {
namespace {

constexpr int kQuality = 95;

}  // namespace

Result<std::string> EncodeJpeg(const ByteImage& image) {
  const bool is_grey = image.Channels() == 1;
  if (image.IsEmpty() || (!is_grey && image.Channels() != 3)) {
    return Error{ErrorCode::kUsage, "a JPEG file holds grey or colours and at least one pixel"};
  }
  if (image.Width() > kMostJpegSide || image.Height() > kMostJpegSide) {
    return Error{ErrorCode::kResources,
                 fmt::format("a side of a JPEG picture has at most {} pixels", kMostJpegSide)};
  }
  const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), &tjDestroy);
  if (!encoder) return Error{ErrorCode::kResources, "no memory for a JPEG encoder"};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): the library's type.
  // With the exact transform, for the same bytes whatever the processor.
  const int status = tjCompress2(encoder.get(), image.Samples().data(), image.Width(), 0,
                                 image.Height(), is_grey ? TJPF_GRAY : TJPF_RGB, &bytes, &size,
                                 is_grey ? TJSAMP_GRAY : TJSAMP_444, kQuality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(bytes, &tjFree);
  if (status != 0) {
    return Error{ErrorCode::kResources,
                 fmt::format("the picture cannot be encoded: {}", tjGetErrorStr2(encoder.get()))};
  }
  return std::string(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace candela
