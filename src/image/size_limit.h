#pragma once

#include <cstdint>

#include "base/result.h"

namespace candela {

/// The memory that the pixels of one file may take unless the caller says otherwise: 2 GiB.
inline constexpr int64_t kMostImageBytes = int64_t{1} << 31;

/// Judges the size that a file claims before memory is taken for it: each side from 1 to 2^31 - 1,
/// and the pixels within `most_bytes` and within the memory that is left. A side that is wrong is
/// an input error, a picture that is too large is a lack of resources.
Result<void> CheckImageSize(int64_t width, int64_t height, int64_t bytes_per_pixel,
                            int64_t most_bytes = kMostImageBytes);

}  // namespace candela
