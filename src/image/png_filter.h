#pragma once

#include <cstddef>
#include <cstdint>

namespace candela {

/// How a scanline of a PNG is expressed by its neighbours (ISO/IEC 15948, clause 9).
enum class PngFilter : uint8_t { kNone = 0, kSub = 1, kUp = 2, kAverage = 3, kPaeth = 4 };

/// Turns `size` filtered bytes back into samples, in place. `prior` is the finished scanline above,
/// or zeros. `bytes_per_pixel` is 1, 2, 3, 4, 6 or 8 and divides `size`.
void UnfilterRow(PngFilter filter, int bytes_per_pixel, uint8_t* row, const uint8_t* prior,
                 size_t size);

/// The reverse: writes the filtered form of `row` to `out`.
void FilterRow(PngFilter filter, int bytes_per_pixel, const uint8_t* row, const uint8_t* prior,
               size_t size, uint8_t* out);

}  // namespace candela
