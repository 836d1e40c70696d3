#include "textures/daylight_map.h"

#include <utility>

#include "base/parallel.h"
#include "math/elementary.h"
#include "textures/lat_long.h"

namespace candela {
namespace {

// The sky varies slowly: texels of 0.7 degrees miss less than a thousandth of it.
constexpr int kColumns = 512, kRows = 256, kHorizon = kRows / 2;

/// The irradiance that the texels above the horizon give to level ground.
Rgb IrradianceOfSky(const Image& map) {
  Vec3d irradiance;
  for (int y = 0; y < kHorizon; ++y) {
    Vec3d row;
    for (int x = 0; x < kColumns; ++x) {
      row = row + Vec3d{map.At(x, y, 0), map.At(x, y, 1), map.At(x, y, 2)};
    }
    // The integral of the cosine over the solid angle of the row, a ring around the zenith.
    const double above = Sin(kPi * y / kRows), below = Sin(kPi * (y + 1) / kRows);
    irradiance = irradiance + row * (kPi * (below * below - above * above) / kColumns);
  }
  return ToFloat(irradiance);
}

void Fill(int first_row, int rows, Image* map, const auto& radiance) {
  ParallelFor(rows, [&](int64_t row) {
    const int y = first_row + static_cast<int>(row);
    for (int x = 0; x < kColumns; ++x) {
      const Vec2 place{(static_cast<float>(x) + 0.5f) / kColumns,
                       (static_cast<float>(y) + 0.5f) / kRows};
      const Rgb colour = radiance(DirectionOfLatLong(place));
      for (int c = 0; c < 3; ++c) map->At(x, y, c) = colour[c];
    }
  });
}

}  // namespace

EnvironmentMap MakeDaylightMap(const Daylight& daylight, Vec3 to_sun, Rgb sun_irradiance,
                               Rgb ground_albedo, float scale) {
  Image map(kColumns, kRows, 3);
  Fill(0, kHorizon, &map, [&](Vec3 direction) { return daylight.SkyRadiance(direction); });
  const Rgb irradiance = IrradianceOfSky(map) + sun_irradiance * to_sun.y;
  const Rgb ground = ground_albedo * irradiance / static_cast<float>(kPi);
  Fill(kHorizon, kRows - kHorizon, &map, [&](Vec3) { return ground; });
  return EnvironmentMap(std::move(map), scale, 0);
}

}  // namespace candela
