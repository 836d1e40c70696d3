#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "textures/mip_map.h"
#include "textures/texture.h"
#include "textures/texture_context.h"
#include "textures/uv_transform.h"

namespace candela {

/// A picture from a file.
class ImageTexture final : public Texture {
 public:
  ImageTexture(MipMap picture, const UvTransform& transform)
      : picture_(std::move(picture)), transform_(transform) {}
  /// Null when the file cannot be read, which is reported.
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;
  uint64_t MemoryBytes() const override { return picture_.MemoryBytes(); }

 private:
  MipMap picture_;
  UvTransform transform_;
};

}  // namespace candela
