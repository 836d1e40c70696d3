// EXR files: a picture or an error, and a picture survives being written and read again.
#include <algorithm>
#include <bit>

#include "base/check.h"
#include "image/exr.h"

namespace {

/// Equal bits: NaN is a value like any other here.
bool IsSame(const candela::Image& a, const candela::Image& b) {
  return a.Width() == b.Width() && a.Height() == b.Height() && a.Channels() == b.Channels() &&
         std::equal(a.Samples().begin(), a.Samples().end(), b.Samples().begin(),
                    [](float x, float y) {
                      return std::bit_cast<uint32_t>(x) == std::bit_cast<uint32_t>(y);
                    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto all = DecodeExrChannels(bytes, kMostBytes);
  CHECK(!all || all->channels.size() == static_cast<size_t>(all->image.Channels()));
  const auto decoded = DecodeExr(bytes, kMostBytes);
  if (!decoded) {
    CHECK(!decoded.error().message.empty() && decoded.error().message.size() < 400);
    return 0;
  }
  CHECK(all && decoded->Channels() >= 1 && decoded->Channels() <= 4);
  const auto written = EncodeExr(*decoded);
  CHECK(written.ok());
  const auto again = DecodeExr(*written, kMostBytes);
  CHECK(again.ok() && IsSame(*again, *decoded));
  return 0;
}
