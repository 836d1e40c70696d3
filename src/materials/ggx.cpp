#include "materials/ggx.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

constexpr auto kPiF = static_cast<float>(kPi);

}  // namespace

float Ggx::Density(Vec3 m) const {
  const float x = m.x / alpha_x, y = m.y / alpha_y;
  const float s = x * x + y * y + m.z * m.z;
  return 1 / (kPiF * alpha_x * alpha_y * s * s);
}

float Ggx::Lambda(Vec3 w) const {
  const float x = w.x * alpha_x, y = w.y * alpha_y;
  // Grazing directions see nothing: the quotient is infinite, and so is the result.
  return (std::sqrt(1 + (x * x + y * y) / (w.z * w.z)) - 1) / 2;
}

// Stretched by the roughness the facets are those of a hemisphere. A hemisphere throws light from
// `wo` into a cap of the sphere, in which all directions are equally frequent; the normal of each
// lies half-way.
Vec3 Ggx::SampleVisible(Vec3 wo, Vec2 u) const {
  const Vec3 stretched = Normalize(Vec3{alpha_x * wo.x, alpha_y * wo.y, wo.z});
  const float phi = 2 * kPiF * u.x;
  const float z = (1 - u.y) * (1 + stretched.z) - stretched.z;
  const float radius = std::sqrt(std::max(0.0f, 1 - z * z));
  const Vec3 m = Vec3{radius * Cos(phi), radius * Sin(phi), z} + stretched;
  return Normalize(Vec3{alpha_x * m.x, alpha_y * m.y, std::max(m.z, 1e-7f)});
}

float Ggx::VisibleDensity(Vec3 wo, Vec3 m) const {
  return Masking(wo) * std::max(0.0f, Dot(wo, m)) * Density(m) / wo.z;
}

}  // namespace candela
