#include "image/quantise.h"

#include <algorithm>
#include <array>

namespace candela {
namespace {

/// Samples go in groups of a fixed size, because compilers turn such a loop into vector
/// instructions without being asked for their highest optimisation level.
template <class T, class Quantise>
Raster<T> Map(const Image& image, Quantise quantise) {
  constexpr size_t kGroup = 32;
  Raster<T> result(image.Width(), image.Height(), image.Channels());
  const float* from = image.Samples().data();
  T* to = result.Samples().data();
  const size_t count = image.Samples().size();
  size_t i = 0;
  for (; i + kGroup <= count; i += kGroup) {
    // A local array, since bytes written through `to` might change `from` for all the compiler
    // knows.
    std::array<T, kGroup> group;
    for (size_t k = 0; k < kGroup; ++k) group[k] = quantise(from[i + k]);
    std::copy(group.begin(), group.end(), to + i);
  }
  for (; i < count; ++i) to[i] = quantise(from[i]);
  return result;
}

}  // namespace

ByteImage QuantiseToBytes(const Image& image) {
  return Map<uint8_t>(image, [](float c) { return QuantiseToByte(c); });
}
ByteImage RoundToBytes(const Image& image) {
  return Map<uint8_t>(image, [](float c) { return RoundToByte(c); });
}
WordImage QuantiseToWords(const Image& image) {
  return Map<uint16_t>(image, [](float c) { return QuantiseToWord(c); });
}

}  // namespace candela
