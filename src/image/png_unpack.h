#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "image/png_chunks.h"

namespace candela {

/// A file for libspng to read in place of the one it came from: only header and scanlines, these
/// stored and not compressed, all checksums zero.
///
/// Handed the file itself, the library stops unpacking at the last pixel, so it reports neither
/// data beyond the picture nor a checksum of the pixels that is wrong or cut off. Therefore zlib
/// unpacks the data here, once. Nor does the library see a palette: an index beyond its end would
/// become black, so an indexed picture is called a grey one and the indices are looked up later.
struct UnpackedPng {
  std::string file;
  bool has_surplus = false;  ///< There is more data than the picture needs. It is not unpacked.
};

/// Errors: too little data, damaged data, a wrong or missing checksum of the data. Takes memory
/// only if the data is long enough to fill it.
Result<UnpackedPng> UnpackPng(const PngChunks& png);

}  // namespace candela
