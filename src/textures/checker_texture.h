#pragma once

#include <memory>

#include "textures/texture_input.h"
#include "textures/uv_transform.h"

namespace candela {

/// The squares of a chess board, each as large as a unit of the texture coordinates.
class CheckerTexture final : public Texture {
 public:
  CheckerTexture(ColorInput even, ColorInput odd, const UvTransform& transform)
      : even_(std::move(even)), odd_(std::move(odd)), transform_(transform) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;

 private:
  ColorInput even_, odd_;
  UvTransform transform_;
};

}  // namespace candela
