#include "film/encode_film.h"

#include <algorithm>

#include "base/parallel.h"
#include "image/png_write.h"
#include "image/quantise.h"

namespace candela {
namespace {

/// A picture whose samples are what `convert` makes of those of the film.
template <class T, class Convert>
Raster<T> Develop(const Film& film, Convert convert) {
  const PixelWindow& window = film.Window();
  Raster<T> picture(window.Width(), window.Height(), 3);
  ParallelFor(window.Height(), [&](int64_t row) {
    const int y = static_cast<int>(row);
    std::ranges::transform(film.Row(window.y0 + y), picture.Row(y).begin(), convert);
  });
  return picture;
}

}  // namespace

Image ToImage(const Film& film) {
  return Develop<float>(film, [](float value) { return value; });
}

Result<std::string> EncodeFilm(const Film& film, ImageFormat format, const EncodeOptions& options) {
  if (format == ImageFormat::kPng && options.png_bits == 8) {
    // In a lambda, which is expanded in place where a pointer to the function would be called.
    return EncodePng(Develop<uint8_t>(film, [](float value) { return QuantiseToByte(value); }));
  }
  return EncodeImage(ToImage(film), format, options);
}

}  // namespace candela
