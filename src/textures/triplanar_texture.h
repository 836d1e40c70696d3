#pragma once

#include <memory>
#include <utility>

#include "scene_spec/param_reader.h"
#include "textures/solid_place.h"
#include "textures/texture.h"
#include "textures/texture_context.h"

namespace candela {

/// Another texture for surfaces without good texture coordinates: thrown onto them along the three
/// axes, each the more, the more the surface looks that way.
class TriplanarTexture final : public Texture {
 public:
  /// The larger the `sharpness`, the narrower is the seam between two sides; above 0.
  TriplanarTexture(std::shared_ptr<const Texture> texture, float sharpness, const SolidPlace& place)
      : texture_(std::move(texture)), sharpness_(sharpness), place_(place) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;
  bool NeedsTextureCoordinates() const override { return texture_->NeedsTextureCoordinates(); }

 private:
  std::shared_ptr<const Texture> texture_;
  float sharpness_;
  SolidPlace place_;
};

}  // namespace candela
