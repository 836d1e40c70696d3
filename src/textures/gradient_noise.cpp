#include "textures/gradient_noise.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

/// The height at `d` of a slope towards one of the twelve edges of a cube.
float Slope(uint32_t hash, Vec3 d) {
  const uint32_t h = hash & 15;
  const float u = h < 8 ? d.x : d.y;
  const float v = h < 4 ? d.y : h == 12 || h == 14 ? d.x : d.z;
  return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

/// From 0 to 1 with two derivatives of 0 at either end.
float Fade(float t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

float Blend(float a, float b, float t) {
  return a + t * (b - a);
}

}  // namespace

float GradientNoise(Vec3 p) {
  constexpr float kFarthest = 0x1p30f;
  const Vec3 far = Abs(p);
  if (!(far.x < kFarthest && far.y < kFarthest && far.z < kFarthest)) return 0;

  const Vec3 floor{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const auto x = static_cast<int32_t>(floor.x), y = static_cast<int32_t>(floor.y),
             z = static_cast<int32_t>(floor.z);
  const Vec3 d = p - floor;
  const auto corner = [&](int i, int j, int k) {
    const Vec3 from{d.x - static_cast<float>(i), d.y - static_cast<float>(j),
                    d.z - static_cast<float>(k)};
    return Slope(HashOfCell(x + i, y + j, z + k), from);
  };
  const float u = Fade(d.x), v = Fade(d.y), w = Fade(d.z);
  const float near = Blend(Blend(corner(0, 0, 0), corner(1, 0, 0), u),
                           Blend(corner(0, 1, 0), corner(1, 1, 0), u), v);
  const float back = Blend(Blend(corner(0, 0, 1), corner(1, 0, 1), u),
                           Blend(corner(0, 1, 1), corner(1, 1, 1), u), v);
  return std::clamp(Blend(near, back, w), -1.0f, 1.0f);
}

}  // namespace candela
