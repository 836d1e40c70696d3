#include "integrators/distribution_draws.h"

#include <algorithm>
#include <cmath>

#include "materials/fresnel.h"
#include "math/elementary.h"
#include "math/frame.h"

namespace candela {

// A bijection of 32 bits that spreads each over all of them, by C. Wellons ("lowbias32", 2018).
uint32_t NameOf(uint32_t parent, uint32_t branch) {
  uint32_t x = parent * 0x9e3779b9u + branch;
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

Vec3 SampleAbout(Vec3 axis, float roughness, Vec2 u) {
  if (roughness == 0) return axis;
  // The exponent is 1 / (2 alpha^2), and the cosine u to the power of 1 / (exponent + 1).
  const double alpha = double{roughness} * double{roughness};
  const double power = 2 * alpha * alpha / (1 + 2 * alpha * alpha);
  const double cosine = Pow(1 - double{u.x}, power);
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const double around = 2 * kPi * double{u.y};
  return Frame::FromNormal(axis).ToWorld(
      ToFloat(Vec3d{sine * Cos(around), sine * Sin(around), cosine}));
}

// Snell's law: along the surface the direction is shortened by eta.
Refraction Refract(Vec3 d, Vec3 n, float eta) {
  const float cosine = std::clamp(-Dot(d, n), 0.0f, 1.0f);
  float beyond;
  const float reflectance = DielectricReflectance(cosine, eta, &beyond);
  return {reflectance, Normalize((d + n * cosine) / eta - n * beyond)};
}

}  // namespace candela
