#include "textures/fractal_noise.h"

#include <cmath>

#include "textures/gradient_noise.h"

namespace candela {

FractalNoise::FractalNoise(int octaves, float gain, float lacunarity)
    : octaves_(octaves), gain_(gain), lacunarity_(lacunarity), most_(0) {
  float strength = 1;
  for (int i = 0; i < octaves; ++i, strength *= gain) most_ += strength;
}

FractalNoise FractalNoise::Create(ParamReader* params, int default_octaves) {
  const auto octaves = static_cast<int>(params->Integer("octaves", default_octaves, 1, 16));
  const float gain = params->Fraction("gain", 0.5f);
  return {octaves, gain, params->Positive("lacunarity", 2)};
}

template <class Copy>
float FractalNoise::Sum(Vec3 p, float width, const Copy& copy) const {
  // Else all copies would be 0 in the same places.
  constexpr Vec3 kShift{17.37f, 5.71f, 11.13f};
  float sum = 0, strength = 1;
  for (int i = 0; i < octaves_; ++i) {
    sum += strength * copy(p, DetailLeft(width));
    strength *= gain_;
    p = p * lacunarity_ + kShift;
    width *= lacunarity_;
  }
  return sum / most_;
}

float FractalNoise::Motion(Vec3 p, float width) const {
  return Sum(p, width,
             [](Vec3 at, float detail) { return detail > 0 ? detail * GradientNoise(at) : 0; });
}

float FractalNoise::Turbulence(Vec3 p, float width) const {
  return Sum(p, width, [](Vec3 at, float detail) {
    const float rest = (1 - detail) * kMeanGradientNoise;
    return detail > 0 ? detail * std::abs(GradientNoise(at)) + rest : rest;
  });
}

float DetailLeft(float width_over_period) {
  if (!(width_over_period > 0.5f)) return 1;
  if (!(width_over_period < 1)) return 0;
  const float t = 2 * width_over_period - 1;
  return 1 - t * t * (3 - 2 * t);
}

}  // namespace candela
