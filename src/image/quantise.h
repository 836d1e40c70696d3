#pragma once

#include <cstdint>

#include "image/raster.h"

namespace candela {

/// The byte for a value by the course's rule: 255 c cut to a whole number, then clamped to 0..255.
/// No rounding, gamma or tone curve. NaN is 0; whatever is large is 255.
inline uint8_t QuantiseToByte(float c) {
  // Written so that NaN fails the first comparison, and clamped before the conversion, which is
  // undefined for large values.
  const float scaled = 255.0f * c;
  const float low = scaled > 0.0f ? scaled : 0.0f;
  return static_cast<uint8_t>(static_cast<int>(low < 255.0f ? low : 255.0f));
}

/// The nearest byte: 255 c + 1/2 cut to a whole number, clamped to 0..255; NaN is 0.
inline uint8_t RoundToByte(float c) {
  const float scaled = 255.0f * c + 0.5f;
  const float low = scaled > 0.0f ? scaled : 0.0f;
  return static_cast<uint8_t>(static_cast<int>(low < 255.0f ? low : 255.0f));
}

/// The nearest 16-bit value: 65535 c + 1/2 cut to a whole number, clamped to 0..65535; NaN is 0.
/// The course has no 16-bit files, so nothing has to be matched here, and rounding halves the
/// error.
inline uint16_t QuantiseToWord(float c) {
  const float scaled = 65535.0f * c + 0.5f;
  const float low = scaled > 0.0f ? scaled : 0.0f;
  return static_cast<uint16_t>(static_cast<int>(low < 65535.0f ? low : 65535.0f));
}

/// The same for every sample.
ByteImage QuantiseToBytes(const Image& image);
ByteImage RoundToBytes(const Image& image);
WordImage QuantiseToWords(const Image& image);

}  // namespace candela
