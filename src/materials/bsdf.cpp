#include "materials/bsdf.h"

#include "math/elementary.h"
#include "sampling/warp.h"

namespace candela {
namespace {

constexpr float kInvPi = static_cast<float>(1 / kPi);

bool IsAbove(const Bsdf& bsdf, Vec3 w) {
  return Dot(bsdf.frame.z, w) > 0;
}

}  // namespace

Spectrum Eval(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
  Spectrum sum;
  if (!IsAbove(bsdf, wo) || !IsAbove(bsdf, wi)) return sum;
  for (int i = 0; i < bsdf.count; ++i) sum += bsdf.lobes[i].weight * kInvPi;
  return sum;
}

BsdfSample Sample(const Bsdf& bsdf, Vec3 wo, Vec2 u) {
  if (bsdf.count == 0 || !IsAbove(bsdf, wo)) return {};
  const Vec3 local = SampleCosineHemisphere(u);
  BsdfSample sample;
  sample.wi = bsdf.frame.ToWorld(local);
  sample.pdf = CosineHemispherePdf(local.z);
  // The cosine of the estimator and that of the density cancel: what remains is the albedo.
  for (int i = 0; i < bsdf.count; ++i) sample.weight += bsdf.lobes[i].weight;
  return sample;
}

float Pdf(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
  if (bsdf.count == 0 || !IsAbove(bsdf, wo) || !IsAbove(bsdf, wi)) return 0;
  return CosineHemispherePdf(Dot(bsdf.frame.z, wi));
}

}  // namespace candela
