// JPEG files: a picture of the size that the header claims, or an error; what was read can be
// written and read again.
#include "image/jpeg.h"
#include "base/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto decoded = DecodeJpeg(bytes, kMostBytes);
  if (!decoded) {
    CHECK(!decoded.error().message.empty() && decoded.error().message.size() < 400);
    return 0;
  }
  CHECK(decoded->Channels() == 1 || decoded->Channels() == 3);
  const auto written = EncodeJpeg(*decoded);
  CHECK(written.ok());
  const auto again = DecodeJpeg(*written);
  CHECK(again.ok() && again->Width() == decoded->Width() && again->Height() == decoded->Height());
  return 0;
}
