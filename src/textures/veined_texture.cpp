#include "textures/veined_texture.h"

#include <cmath>
#include <utility>

#include "math/elementary.h"

namespace candela {
namespace {

std::shared_ptr<const Texture> Make(VeinedTexture::Pattern pattern, float default_strength,
                                    int default_octaves, ParamReader* params,
                                    const TextureContext& context) {
  ColorRange colors = ColorRange::Create(params, context);
  const float strength = params->NonNegative("strength", default_strength);
  const FractalNoise noise = FractalNoise::Create(params, default_octaves);
  return std::make_shared<VeinedTexture>(pattern, std::move(colors), strength, noise,
                                         SolidPlace::Create(params));
}

/// Part of the way from one sheet or ring to the next.
float Phase(float distance) {
  const float phase = distance - std::floor(distance);
  return std::isfinite(phase) ? phase : 0;
}

float SheetAt(float phase) {
  return 0.5f + 0.5f * Sin(static_cast<float>(2 * kPi) * phase);
}

/// Grows through the year and ends within a part of it.
float RingAt(float phase) {
  constexpr float kEnd = 0.8f;
  return phase < kEnd ? phase / kEnd : (1 - phase) / (1 - kEnd);
}

}  // namespace

std::shared_ptr<const Texture> VeinedTexture::CreateMarble(ParamReader* params,
                                                           const TextureContext& context) {
  return Make(Pattern::kSheets, 2, 6, params, context);
}

std::shared_ptr<const Texture> VeinedTexture::CreateWood(ParamReader* params,
                                                         const TextureContext& context) {
  return Make(Pattern::kRings, 0.5f, 3, params, context);
}

Rgb VeinedTexture::Lookup(const SurfacePoint& point) const {
  const auto [p, size] = place_.At(point);
  const float width = point.footprint * size;
  const bool is_marble = pattern_ == Pattern::kSheets;
  const float distance = is_marble ? p.x : std::sqrt(p.x * p.x + p.z * p.z);
  const float phase = Phase(distance + strength_ * noise_.Motion(p, width));
  const float value = is_marble ? SheetAt(phase) : RingAt(phase);
  // Both patterns have a mean of 1/2.
  return colors_.At(0.5f + (value - 0.5f) * DetailLeft(width), point);
}

}  // namespace candela
