#pragma once

#include <optional>

#include "math/spectrum.h"
#include "textures/cube_map.h"

namespace candela {

/// What rays see that hit nothing, and the light that is everywhere.
struct Background {
  Rgb color;
  Rgb ambient_light;
  std::optional<CubeMap> cube_map;  ///< Replaces `color`.

  Spectrum Radiance(Vec3 direction) const {
    return Spectrum(cube_map ? cube_map->Lookup(direction) : color);
  }
};

}  // namespace candela
