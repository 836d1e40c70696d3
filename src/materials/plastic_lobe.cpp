#include "materials/plastic_lobe.h"

#include <algorithm>

#include "materials/energy_table.h"
#include "materials/fresnel.h"
#include "math/elementary.h"
#include "sampling/warp.h"

namespace candela {
namespace {

constexpr auto kInvPi = static_cast<float>(1 / kPi);

bool IsPolished(const PlasticParams& plastic) {
  return plastic.surface.alpha_x < kSmoothestAlpha;
}

/// The share of the light at a cosine to the normal that the coat reflects.
float CoatShare(const PlasticParams& plastic, float cosine) {
  if (!IsPolished(plastic)) return plastic.energy->At(cosine, plastic.table_row);
  float beyond;
  return DielectricReflectance(std::min(cosine, 1.0f), plastic.eta, &beyond);
}

/// What comes out again of the light that got into the coat: of diffuse light inside, the underside
/// of the coat reflects the share r, and n^2 (1 - r) is the mean share that a coat lets in from
/// outside.
Spectrum BaseAlbedo(const Lobe& lobe) {
  const PlasticParams& plastic = lobe.plastic;
  const float let_in = 1 - plastic.mean_share;
  const float r = 1 - let_in / (plastic.eta * plastic.eta);
  const Spectrum rho = lobe.weight;
  return rho * (1 - r) / (Spectrum(1) - rho * r);
}

Spectrum EvalBase(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const PlasticParams& plastic = lobe.plastic;
  const float let_through =
      (1 - CoatShare(plastic, wo.z)) * (1 - CoatShare(plastic, wi.z)) / (1 - plastic.mean_share);
  return BaseAlbedo(lobe) * (let_through * kInvPi);
}

/// How often the coat is drawn: by what it reflects, beside the base.
float CoatChoice(const Lobe& lobe, Vec3 wo) {
  const float coat = CoatShare(lobe.plastic, wo.z);
  const float base = (1 - coat) * BaseAlbedo(lobe).MaxComponent();
  return coat / (coat + base);
}

Spectrum EvalCoat(const PlasticParams& plastic, Vec3 wo, Vec3 wi) {
  const Vec3 half = wo + wi;
  const float length = Length(half);
  // Half of the length is the cosine of both to the facet, with the same rounding.
  float beyond;
  const float reflectance = DielectricReflectance(std::min(length / 2, 1.0f), plastic.eta, &beyond);
  const float facets = plastic.surface.Density(half * (1 / length)) *
                       plastic.surface.MaskingAndShadowing(wo, wi) / (4 * wo.z * wi.z);
  const float value = reflectance * facets;
  return Spectrum(Rgb{value, value, value});
}

float CoatPdf(const PlasticParams& plastic, Vec3 wo, Vec3 wi) {
  const Vec3 m = Normalize(wo + wi);
  return plastic.surface.VisibleDensity(wo, m) / (4 * Dot(wo, m));
}

}  // namespace

Spectrum EvalPlastic(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const Spectrum base = EvalBase(lobe, wo, wi);
  return IsPolished(lobe.plastic) ? base : base + EvalCoat(lobe.plastic, wo, wi);
}

float PlasticPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const float choice = CoatChoice(lobe, wo);
  const float base = (1 - choice) * CosineHemispherePdf(wi.z);
  return IsPolished(lobe.plastic) ? base : base + choice * CoatPdf(lobe.plastic, wo, wi);
}

LobeSample SamplePlastic(const Lobe& lobe, Vec3 wo, Vec2 u) {
  const PlasticParams& plastic = lobe.plastic;
  const float choice = CoatChoice(lobe, wo);
  LobeSample sample;
  if (!SplitChoice(choice, &u.x)) {
    sample.wi = SampleCosineHemisphere(u);
  } else if (!IsPolished(plastic)) {
    const Vec3 m = plastic.surface.SampleVisible(wo, u);
    sample.wi = m * (2 * Dot(wo, m)) - wo;
  } else {
    sample.wi = MirrorDirection(wo);
    sample.pdf = choice;
    const float weight = CoatShare(plastic, wo.z) / choice;
    sample.weight = Spectrum(Rgb{weight, weight, weight});
    sample.is_delta = true;
    return sample;
  }
  if (!(sample.wi.z > 0)) return {};
  sample.pdf = PlasticPdf(lobe, wo, sample.wi);
  if (!(sample.pdf > 0)) return {};
  sample.weight = EvalPlastic(lobe, wo, sample.wi) * (sample.wi.z / sample.pdf);
  return sample;
}

}  // namespace candela
