#pragma once

#include <string>

#include "base/result.h"
#include "film/film.h"
#include "image/image_file.h"
#include "image/raster.h"

namespace candela {

/// The picture of a film's window.
Image ToImage(const Film& film);

/// The same bytes as `EncodeImage(ToImage(film), format, options)`. The usual file, a PNG of 8
/// bits, is made without the floats in between: fresh memory for them costs more than the
/// conversion.
Result<std::string> EncodeFilm(const Film& film, ImageFormat format,
                               const EncodeOptions& options = {});

}  // namespace candela
