// The Radiance reader: what it accepts is finite, not negative, and survives being written.
#include "image/hdr.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  std::vector<std::string> warnings;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Result<Image> image = DecodeHdr(bytes, &warnings, kMostBytes);
  if (!image) return 0;
  CHECK(image->Channels() == 3 && !image->IsEmpty());
  const std::span<const float> samples = image->Samples();
  CHECK(std::all_of(samples.begin(), samples.end(),
                    [](float value) { return std::isfinite(value) && value >= 0.0f; }));

  const Result<std::string> file = EncodeHdr(*image);
  CHECK(file.ok());
  const Result<Image> again = DecodeHdr(*file);
  CHECK(again.ok() && again->Width() == image->Width() && again->Height() == image->Height());
  return 0;
}
