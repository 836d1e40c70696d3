#pragma once

#include "textures/daylight.h"
#include "textures/environment_map.h"

namespace candela {

/// A picture of the sky, and below the horizon of level ground that it and the sun light: the
/// ground throws back `ground_albedo` of its irradiance to all directions. The sun itself is not in
/// it; it gives `sun_irradiance`, at normal incidence. All of it is multiplied by `scale`.
EnvironmentMap MakeDaylightMap(const Daylight& daylight, Vec3 to_sun, Rgb sun_irradiance,
                               Rgb ground_albedo, float scale);

}  // namespace candela
