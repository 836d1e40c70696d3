#include "driver/lens_effects.h"

#include <algorithm>

#include "base/parallel.h"
#include "image/bloom.h"
#include "render/sample_placer.h"

namespace candela {

uint64_t LensEffects::BytesPerPixel() const {
  return HasBloom() ? 3 * kBloomBytesPerSample : 0;
}

FilmEncoder::Finishing LensEffects::Finishing(const Camera& camera,
                                              const RenderOptions& options) const {
  if (!HasBloom() && vignette == 0) return {};
  return [effects = *this, &camera, &options](Image* picture) {
    if (effects.vignette > 0) effects.AddVignette(camera, options, picture);
    const float radius = effects.bloom_radius * static_cast<float>(options.height);
    if (effects.HasBloom()) AddBloom({effects.bloom_strength, radius}, picture);
  };
}

// A flat film gets the light of a small lens by the fourth power of the cosine: two for the square
// of the distance, one for the slant of the lens and one for that of the film.
void LensEffects::AddVignette(const Camera& camera, const RenderOptions& options,
                              Image* picture) const {
  const SamplePlacer placer(options);
  ParallelFor(picture->Height(), [&](int64_t row) {
    const auto y = static_cast<int>(row);
    for (int x = 0; x < picture->Width(); ++x) {
      const Vec2 image_point = placer.Centre(options.crop.x0 + x, options.crop.y0 + y).image_point;
      const float cosine = std::max(0.0f, camera.CosineOnFlatFilm(image_point).value_or(1));
      const float squared = cosine * cosine;
      const float gain = (1 - vignette) + vignette * squared * squared;
      for (float& value : picture->Pixel(x, y)) value *= gain;
    }
  });
}

}  // namespace candela
