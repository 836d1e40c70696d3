#pragma once

#include <cstdint>
#include <memory>

#include "scene_spec/param_reader.h"
#include "textures/color_range.h"
#include "textures/solid_place.h"
#include "textures/texture.h"

namespace candela {

/// Cells around scattered points that fill space: stones, scales, cracked earth.
class VoronoiTexture final : public Texture {
 public:
  enum class Feature : uint8_t {
    kDistance,  ///< To the nearest point, in units between points, at most 1.
    kEdges,     ///< How much farther the second one is, at most 1: 0 where two cells meet.
    kCells,     ///< A number for each cell.
  };

  /// `jitter` from 0, where points stand in line, to 1.
  VoronoiTexture(Feature feature, float jitter, ColorRange colors, const SolidPlace& place);
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;

 private:
  float ValueAt(Vec3 p) const;

  Feature feature_;
  float jitter_;
  float mean_;
  ColorRange colors_;
  SolidPlace place_;
};

}  // namespace candela
