#include "materials/fresnel.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

float ConductorReflectance(float cosine, float eta, float k) {
  const float cos2 = cosine * cosine, sin2 = 1 - cos2;
  const float eta2 = eta * eta, k2 = k * k;
  const float t0 = eta2 - k2 - sin2;
  const float a2_plus_b2 = std::sqrt(t0 * t0 + 4 * eta2 * k2);
  const float a = std::sqrt(std::max(0.0f, 0.5f * (a2_plus_b2 + t0)));
  const float t1 = a2_plus_b2 + cos2, t2 = 2 * a * cosine;
  const float s = (t1 - t2) / (t1 + t2);
  const float t3 = cos2 * a2_plus_b2 + sin2 * sin2, t4 = t2 * sin2;
  // Both are 0 head-on to an index of 0, which reflects all light of any other angle.
  if (!(t3 + t4 > 0)) return s;
  return 0.5f * (s + s * (t3 - t4) / (t3 + t4));
}

/// The mean of a function of the cosine over the hemisphere, weighted by it. Midpoints in the
/// square of the cosine, which is uniform then; their number makes up for the steep end.
template <class T, class Function>
T CosineMean(const Function& function) {
  constexpr int kSteps = 2000;
  T sum{};
  for (int i = 0; i < kSteps; ++i) {
    const float square = (static_cast<float>(i) + 0.5f) / kSteps;
    sum += function(std::sqrt(square)) * (1.0f / kSteps);
  }
  return sum;
}

}  // namespace

float DielectricReflectance(float cosine, float eta, float* cos_beyond) {
  const float sin2_beyond = std::max(0.0f, 1 - cosine * cosine) / (eta * eta);
  if (!(sin2_beyond < 1)) {
    *cos_beyond = 0;
    return 1;
  }
  const float beyond = std::sqrt(1 - sin2_beyond);
  *cos_beyond = beyond;
  const float s = (cosine - eta * beyond) / (cosine + eta * beyond);
  const float p = (eta * cosine - beyond) / (eta * cosine + beyond);
  return std::min(0.5f * (s * s + p * p), 1.0f);
}

Rgb ConductorReflectance(float cosine, Rgb eta, Rgb k) {
  return {ConductorReflectance(cosine, eta.x, k.x), ConductorReflectance(cosine, eta.y, k.y),
          ConductorReflectance(cosine, eta.z, k.z)};
}

float MeanDielectricReflectance(float eta) {
  return static_cast<float>(CosineMean<double>([eta](float cosine) {
    float beyond;
    return static_cast<double>(DielectricReflectance(cosine, eta, &beyond));
  }));
}

Rgb MeanConductorReflectance(Rgb eta, Rgb k) {
  return CosineMean<Rgb>([&](float cosine) { return ConductorReflectance(cosine, eta, k); });
}

}  // namespace candela
