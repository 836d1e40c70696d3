#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/raster.h"
#include "image/size_limit.h"

namespace candela {

/// Reads a Radiance picture (".hdr": three mantissas with a common exponent, about 1 % precision):
/// plain, or with either of the format's run-length codings. The rows may be stored in any of the
/// four orders of the signs in "-Y H +X W"; pictures stored by columns and XYZ colours are errors.
/// The lines EXPOSURE and COLORCORR are not applied. Gives three channels.
Result<Image> DecodeHdr(std::string_view bytes, std::vector<std::string>* warnings = nullptr,
                        int64_t most_bytes = kMostImageBytes);

/// The bytes of such a file, run-length coded where the width allows. One to four channels: grey is
/// repeated, alpha is left out. Each colour is rounded to the nearest one of the format; negative
/// values and NaN become 0, what is too large becomes the largest.
Result<std::string> EncodeHdr(const Image& image);

}  // namespace candela
