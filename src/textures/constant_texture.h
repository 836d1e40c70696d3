#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "textures/texture.h"
#include "textures/texture_context.h"

namespace candela {

/// The same colour everywhere: a colour with a name.
class ConstantTexture final : public Texture {
 public:
  explicit ConstantTexture(Rgb color) : color_(color) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext&) {
    return std::make_shared<ConstantTexture>(params->Color("color", {1, 1, 1}));
  }

  Rgb Lookup(const SurfacePoint&) const override { return color_; }
  bool NeedsTextureCoordinates() const override { return false; }

 private:
  Rgb color_;
};

}  // namespace candela
