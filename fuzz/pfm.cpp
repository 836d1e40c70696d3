// The reader of portable float maps: what it accepts survives being written, bit by bit.
#include "image/pfm.h"

#include <cstring>

#include "base/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  std::vector<std::string> warnings;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Result<Image> image = DecodePfm(bytes, &warnings, kMostBytes);
  if (!image) return 0;
  CHECK(!image->IsEmpty() && (image->Channels() == 1 || image->Channels() == 3));

  for (const ByteOrder order : {ByteOrder::kLittle, ByteOrder::kBig}) {
    const Result<std::string> file = EncodePfm(*image, order);
    CHECK(file.ok());
    const Result<Image> again = DecodePfm(*file);
    CHECK(again.ok() && again->Samples().size() == image->Samples().size());
    // Compared as bytes: NaN differs from itself.
    CHECK(std::memcmp(again->Samples().data(), image->Samples().data(),
                      image->Samples().size_bytes()) == 0);
  }
  return 0;
}
