#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "film/film.h"
#include "image/image_file.h"
#include "image/png_write.h"
#include "image/raster.h"

namespace candela {

/// The picture of a film's window.
Image ToImage(const Film& film);

/// Encodes a film while its lower rows are still being rendered: the usual file, a PNG of 8 bits,
/// is compressed row by row. The others wait for the whole picture.
class FilmEncoder {
 public:
  /// What is done to the colours of the whole picture, the film's window, before they are encoded.
  using Finishing = std::function<void(Image*)>;

  /// The film has to outlive it. One that records layers is for EXR only, as layers beside R, G and
  /// B; the others hold colours. With a `finishing` nothing can be compressed before the end.
  FilmEncoder(const Film& film, ImageFormat format, const EncodeOptions& options,
              Finishing finishing = {});

  /// Says that the rows before `y_end`, counted in the film's window, are final. Rows only get
  /// more. Not to be called by two threads at a time.
  void Advance(int y_end);

  /// The bytes of the file, the same as `EncodeImage(ToImage(film), format, options)` gives of a
  /// picture that was finished; once, when the film is done.
  Result<std::string> Finish();

 private:
  const Film& film_;
  ImageFormat format_;
  EncodeOptions options_;
  Finishing finishing_;
  std::optional<PngRowEncoder> png_;
  int next_row_ = 0;
  std::vector<uint8_t> bytes_;  ///< Of one row.
};

}  // namespace candela
