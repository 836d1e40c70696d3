#include "image/size_limit.h"

#include <fmt/format.h>

#include <limits>

#include "base/check.h"
#include "base/memory.h"

namespace candela {
namespace {

// Asking the system takes some 50 microseconds, more than decoding a small picture.
constexpr int64_t kWorthAsking = int64_t{64} << 20;

}  // namespace

Result<void> CheckImageSize(int64_t width, int64_t height, int64_t bytes_per_pixel,
                            int64_t most_bytes) {
  CHECK(bytes_per_pixel > 0 && most_bytes >= 0);
  constexpr int64_t kMostSide = std::numeric_limits<int>::max();
  if (width < 1 || height < 1 || width > kMostSide || height > kMostSide) {
    return Error{ErrorCode::kInput,
                 fmt::format("a picture of {} x {} pixels is not possible", width, height)};
  }
  // The product of the sides is below 2^62; dividing the limit avoids the next product.
  const int64_t pixels = width * height;
  if (pixels > most_bytes / bytes_per_pixel) {
    return Error{
        ErrorCode::kResources,
        fmt::format("a picture of {} x {} pixels with {} bytes each is beyond the limit of "
                    "{} bytes",
                    width, height, bytes_per_pixel, most_bytes)};
  }
  const int64_t bytes = pixels * bytes_per_pixel;
  if (bytes > kWorthAsking && static_cast<uint64_t>(bytes) > AvailableMemory()) {
    return Error{
        ErrorCode::kResources,
        fmt::format("a picture of {} x {} pixels needs {} bytes, more than the memory that "
                    "is left",
                    width, height, bytes)};
  }
  return {};
}

}  // namespace candela
