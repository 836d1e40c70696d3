#pragma once

#include <cmath>
#include <memory>

#include "scene_spec/param_reader.h"
#include "textures/texture.h"
#include "textures/texture_context.h"
#include "textures/uv_transform.h"

namespace candela {

/// The texture coordinates themselves, each from 0 to 1 again and again: u is red, v is green.
class UvTexture final : public Texture {
 public:
  explicit UvTexture(const UvTransform& transform) : transform_(transform) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext&) {
    return std::make_shared<UvTexture>(UvTransform::Create(params));
  }

  Rgb Lookup(const SurfacePoint& point) const override {
    const Vec2 uv = transform_.Apply(point.uv);
    return {Fraction(uv.x), Fraction(uv.y), 0};
  }

 private:
  static float Fraction(float x) {
    const float fraction = x - std::floor(x);
    return std::isfinite(fraction) ? fraction : 0;
  }

  UvTransform transform_;
};

}  // namespace candela
