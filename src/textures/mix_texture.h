#pragma once

#include <memory>
#include <utility>

#include "scene_spec/param_reader.h"
#include "textures/texture.h"
#include "textures/texture_input.h"

namespace candela {

/// Two colours or textures, and how much of the second.
class MixTexture final : public Texture {
 public:
  MixTexture(ColorInput first, ColorInput second, NumberInput amount)
      : first_(std::move(first)), second_(std::move(second)), amount_(std::move(amount)) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context) {
    ColorInput first = ColorInput::Color(params, "first", {0, 0, 0}, context);
    ColorInput second = ColorInput::Color(params, "second", {1, 1, 1}, context);
    NumberInput amount = NumberInput::Fraction(params, "amount", 0.5f, context);
    return std::make_shared<MixTexture>(std::move(first), std::move(second), std::move(amount));
  }

  Rgb Lookup(const SurfacePoint& point) const override {
    const float t = amount_.At(point);
    return first_.At(point) * (1 - t) + second_.At(point) * t;
  }
  bool NeedsTextureCoordinates() const override {
    return first_.NeedsTextureCoordinates() || second_.NeedsTextureCoordinates() ||
           amount_.NeedsTextureCoordinates();
  }

 private:
  ColorInput first_, second_;
  NumberInput amount_;
};

}  // namespace candela
