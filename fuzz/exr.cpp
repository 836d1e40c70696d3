// The OpenEXR reader: the chosen colours and all channels, within a limit of memory. Every block of
// such a file is found by its offset, so an input that grows or shrinks seldom comes past the
// header; half of the time a mutator of its own changes bytes where they are.
#include "image/exr.h"

#include <random>

#include "base/check.h"

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t max_size);

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t max_size,
                                          unsigned seed) {
  std::minstd_rand random(seed);
  if (size == 0 || random() % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  for (auto changes = 1 + random() % 4; changes > 0; --changes) {
    // Another value, another bit, or one more or less.
    const size_t at = random() % size;
    const unsigned kind = random() % 3;
    data[at] = static_cast<unsigned char>(kind == 0   ? random()
                                          : kind == 1 ? data[at] ^ 1u << random() % 8
                                                      : data[at] + (random() % 2 ? 1u : 255u));
  }
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);

  const Result<ExrPicture> picture = DecodeExrChannels(bytes, kMostBytes);
  if (picture) {
    CHECK(picture->channels.size() == static_cast<size_t>(picture->image.Channels()));
    CHECK(!picture->image.IsEmpty());
    CHECK(static_cast<int64_t>(picture->image.Samples().size_bytes()) <= kMostBytes);
  }
  const Result<Image> image = DecodeExr(bytes, kMostBytes);
  CHECK(!image || (picture && image->Channels() <= picture->image.Channels()));
  return 0;
}
