#include "textures/checker_texture.h"

#include <cmath>

namespace candela {

std::shared_ptr<const Texture> CheckerTexture::Create(ParamReader* params,
                                                      const TextureContext& context) {
  ColorInput even = ColorInput::Color(params, "even", {1, 1, 1}, context);
  ColorInput odd = ColorInput::Color(params, "odd", {0, 0, 0}, context);
  return std::make_shared<CheckerTexture>(std::move(even), std::move(odd),
                                          UvTransform::Create(params));
}

Rgb CheckerTexture::Lookup(const SurfacePoint& point) const {
  const Vec2 uv = transform_.Apply(point.uv);
  // Halves of whole numbers have a fraction of 0 or 1/2, however large they are.
  const float half = (std::floor(uv.x) + std::floor(uv.y)) / 2;
  return (half == std::floor(half) ? even_ : odd_).At(point);
}

}  // namespace candela
