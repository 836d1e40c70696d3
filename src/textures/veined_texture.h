#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "textures/color_range.h"
#include "textures/fractal_noise.h"
#include "textures/solid_place.h"
#include "textures/texture.h"

namespace candela {

/// A regular pattern that fills space, bent by fractal noise: Perlin, "An Image Synthesizer", 1985.
class VeinedTexture final : public Texture {
 public:
  enum class Pattern {
    kSheets,  ///< Marble: sheets across x, one unit apart.
    kRings,   ///< Wood: the rings of a trunk along y, one unit apart.
  };

  /// The pattern is moved by `strength` units at most.
  VeinedTexture(Pattern pattern, ColorRange colors, float strength, const FractalNoise& noise,
                const SolidPlace& place)
      : pattern_(pattern),
        colors_(std::move(colors)),
        strength_(strength),
        noise_(noise),
        place_(place) {}
  static std::shared_ptr<const Texture> CreateMarble(ParamReader* params,
                                                     const TextureContext& context);
  static std::shared_ptr<const Texture> CreateWood(ParamReader* params,
                                                   const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;

 private:
  Pattern pattern_;
  ColorRange colors_;
  float strength_;
  FractalNoise noise_;
  SolidPlace place_;
};

}  // namespace candela
