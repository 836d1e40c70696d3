#include "materials/diffuse_lobes.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {
namespace {

constexpr auto kInvPi = static_cast<float>(1 / kPi);

/// The factor of single scattering, and of its growth with roughness.
float OrenNayarScale(float roughness) {
  constexpr auto kSlope = static_cast<float>(0.5 - 2 / (3 * kPi));
  return 1 / (1 + kSlope * roughness);
}

/// The share that a white surface reflects after one bounce, at a cosine to the normal.
float OrenNayarAlbedo(float cosine, float roughness) {
  const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  // tan (1 - sin^3), written such that nothing cancels at the horizon.
  const float tangent_part = sine * cosine * (1 + sine + sine * sine) / (1 + sine);
  const float g =
      sine * (Acos(std::min(cosine, 1.0f)) - sine * cosine - 2.0f / 3) + 2.0f / 3 * tangent_part;
  return OrenNayarScale(roughness) * (1 + roughness * kInvPi * g);
}

float OrenNayarMeanAlbedo(float roughness) {
  constexpr auto kGrowth = static_cast<float>(2.0 / 3 - 28 / (15 * kPi));
  return OrenNayarScale(roughness) * (1 + kGrowth * roughness);
}

/// How often a direction is drawn without regard to the cosine: seen at a flat angle, a rough
/// surface throws light back as flat.
float UniformShare(const Lobe& lobe, Vec3 wo) {
  return 0.5f * lobe.oren_nayar.roughness * (1 - std::min(wo.z, 1.0f));
}

}  // namespace

Spectrum EvalLambert(const Lobe& lobe) {
  return lobe.weight * kInvPi;
}

Spectrum EvalOrenNayar(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const float roughness = lobe.oren_nayar.roughness;
  const float s = Dot(wo, wi) - wo.z * wi.z;
  const float scaled = s > 0 ? s / std::max(wo.z, wi.z) : s;
  const float single = OrenNayarScale(roughness) * (1 + roughness * scaled) * kInvPi;

  // What is missing has met the surface again, and took on its colour once more each time.
  const float mean = OrenNayarMeanAlbedo(roughness);
  const float missing_o = std::max(0.0f, 1 - OrenNayarAlbedo(wo.z, roughness));
  const float missing_i = std::max(0.0f, 1 - OrenNayarAlbedo(wi.z, roughness));
  const float multiple = missing_o * missing_i * kInvPi / std::max(1 - mean, 1e-7f);
  const Spectrum rho = lobe.weight;
  return rho * single + rho * rho * mean / (Spectrum(1) - rho * (1 - mean)) * multiple;
}

LobeSample SampleLambert(const Lobe& lobe, const DirectionNumbers& numbers) {
  LobeSample sample;
  sample.wi = numbers.OnCosineHemisphere();
  sample.pdf = CosineHemispherePdf(sample.wi.z);
  // The cosine of the estimator and that of the density cancel: what remains is the albedo.
  sample.weight = lobe.weight;
  return sample;
}

float OrenNayarPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const float uniform = UniformShare(lobe, wo);
  return uniform * UniformHemispherePdf() + (1 - uniform) * CosineHemispherePdf(wi.z);
}

LobeSample SampleOrenNayar(const Lobe& lobe, Vec3 wo, Vec2 u) {
  LobeSample sample;
  sample.wi = SplitChoice(UniformShare(lobe, wo), &u.x) ? SampleUniformHemisphere(u)
                                                        : SampleCosineHemisphere(u);
  if (!(sample.wi.z > 0)) return {};
  sample.pdf = OrenNayarPdf(lobe, wo, sample.wi);
  sample.weight = EvalOrenNayar(lobe, wo, sample.wi) * (sample.wi.z / sample.pdf);
  return sample;
}

Spectrum EvalPhong(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const float cosine = Dot(MirrorDirection(wo), wi);
  if (!(cosine > 0)) return {};
  const float n = lobe.phong.exponent;
  return lobe.weight * (0.5f * kInvPi * (n + 2) * Pow(std::min(cosine, 1.0f), n));
}

float PhongPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const float cosine = Dot(MirrorDirection(wo), wi);
  if (!(cosine > 0)) return 0;
  const float n = lobe.phong.exponent;
  return 0.5f * kInvPi * (n + 1) * Pow(std::min(cosine, 1.0f), n);
}

LobeSample SamplePhong(const Lobe& lobe, Vec3 wo, Vec2 u) {
  // The cosine c has the density (n + 1) c^n.
  const float n = lobe.phong.exponent;
  const float cosine = Pow(1 - u.x, 1 / (n + 1));
  const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  const float phi = static_cast<float>(2 * kPi) * u.y;
  const Frame around = Frame::FromNormal(MirrorDirection(wo));
  LobeSample sample;
  sample.wi = around.ToWorld({sine * Cos(phi), sine * Sin(phi), cosine});
  if (!(sample.wi.z > 0)) return {};
  sample.pdf = PhongPdf(lobe, wo, sample.wi);
  sample.weight = lobe.weight * ((n + 2) / (n + 1) * sample.wi.z);
  return sample;
}

}  // namespace candela
