#pragma once

#include <optional>

#include "math/spectrum.h"
#include "textures/cube_map.h"
#include "textures/environment_map.h"

namespace candela {

/// What rays see that hit nothing, and the light that is everywhere.
struct Background {
  Rgb color;
  Rgb ambient_light;
  std::optional<CubeMap> cube_map;            ///< Replaces `color`,
  std::optional<EnvironmentMap> environment;  ///< and so does this; there is one of them at most.

  /// What comes from a direction of any length but 0.
  Spectrum Radiance(Vec3 direction) const {
    if (environment) return Spectrum(environment->Lookup(Normalize(direction)));
    return Spectrum(cube_map ? cube_map->Lookup(direction) : color);
  }
};

}  // namespace candela
