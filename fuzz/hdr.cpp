// HDR files: a picture or an error, and a picture that was written once stays the same. (The first
// time mantissas are brought to full precision, which takes the very darkest colours below the
// format.)
#include "image/hdr.h"
#include "base/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto decoded = DecodeHdr(bytes, nullptr, kMostBytes);
  if (!decoded) {
    CHECK(!decoded.error().message.empty() && decoded.error().message.size() < 400);
    return 0;
  }
  CHECK(decoded->Channels() >= 1 && decoded->Channels() <= 4);
  const auto written = EncodeHdr(*decoded);
  CHECK(written.ok());
  const auto again = DecodeHdr(*written, nullptr, kMostBytes);
  CHECK(again.ok() && EncodeHdr(*again).value() == *written);
  return 0;
}
