#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/raster.h"
#include "image/size_limit.h"

namespace candela {

enum class ByteOrder { kLittle, kBig };

/// Reads a portable float map: "PF" (three channels) or "Pf" (one), width, height, a scale whose
/// sign gives the byte order (negative: little), then 32-bit floats, bottom row first. The size of
/// the scale is a unit of the maker's choice and is not applied.
Result<Image> DecodePfm(std::string_view bytes, std::vector<std::string>* warnings = nullptr,
                        int64_t most_bytes = kMostImageBytes);

/// The bytes of such a file. One to four channels; alpha is left out. The values are unchanged, NaN
/// and infinity included.
Result<std::string> EncodePfm(const Image& image, ByteOrder order = ByteOrder::kLittle);

}  // namespace candela
