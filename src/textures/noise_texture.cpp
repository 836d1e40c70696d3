#include "textures/noise_texture.h"

#include <utility>

namespace candela {
namespace {

std::shared_ptr<const Texture> Make(NoiseTexture::Kind kind, ParamReader* params,
                                    const TextureContext& context) {
  ColorRange colors = ColorRange::Create(params, context);
  const FractalNoise noise = FractalNoise::Create(params, 6);
  return std::make_shared<NoiseTexture>(kind, std::move(colors), noise, SolidPlace::Create(params));
}

}  // namespace

std::shared_ptr<const Texture> NoiseTexture::Create(ParamReader* params,
                                                    const TextureContext& context) {
  return Make(Kind::kMotion, params, context);
}

std::shared_ptr<const Texture> NoiseTexture::CreateTurbulence(ParamReader* params,
                                                              const TextureContext& context) {
  return Make(Kind::kTurbulence, params, context);
}

Rgb NoiseTexture::Lookup(const SurfacePoint& point) const {
  const auto [p, size] = place_.At(point);
  const float width = point.footprint * size;
  const float t =
      kind_ == Kind::kMotion ? 0.5f + 0.5f * noise_.Motion(p, width) : noise_.Turbulence(p, width);
  return colors_.At(t, point);
}

}  // namespace candela
