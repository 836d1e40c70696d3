#pragma once

#include <cstdint>

#include "cameras/camera.h"
#include "film/encode_film.h"
#include "render/render_options.h"

namespace candela {

/// What a lens does to the picture as a whole.
struct LensEffects {
  float bloom_strength = 0;  ///< The part of the light that is spread, from 0 to 1,
  float bloom_radius = 0;    ///< and how far, in heights of the whole picture, from 0 to 1.
  float vignette = 0;        ///< How much it darkens towards the edges, from 0 to 1.

  bool HasBloom() const { return bloom_strength > 0 && bloom_radius > 0; }

  /// The memory in bytes that they take for each pixel, beside the picture.
  uint64_t BytesPerPixel() const;

  /// Adds them to the linear picture of the crop window of `options`: first the vignette, then the
  /// bloom, which spreads light over the window only. None when nothing is to be done. All
  /// arguments have to outlive the result.
  FilmEncoder::Finishing Finishing(const Camera& camera, const RenderOptions& options) const;

 private:
  void AddVignette(const Camera& camera, const RenderOptions& options, Image* picture) const;
};

}  // namespace candela
