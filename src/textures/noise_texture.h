#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "textures/color_range.h"
#include "textures/fractal_noise.h"
#include "textures/solid_place.h"
#include "textures/texture.h"

namespace candela {

/// Clouds: fractal noise that fills space.
class NoiseTexture final : public Texture {
 public:
  enum class Kind { kMotion, kTurbulence };

  NoiseTexture(Kind kind, ColorRange colors, const FractalNoise& noise, const SolidPlace& place)
      : kind_(kind), colors_(std::move(colors)), noise_(noise), place_(place) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context);
  static std::shared_ptr<const Texture> CreateTurbulence(ParamReader* params,
                                                         const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;

 private:
  Kind kind_;
  ColorRange colors_;
  FractalNoise noise_;
  SolidPlace place_;
};

}  // namespace candela
