#include "materials/principled_lobe.h"

#include <algorithm>

#include "materials/fresnel.h"
#include "materials/principled_layers.h"
#include "sampling/warp.h"

namespace candela {
namespace {

Spectrum White() {
  return Spectrum(Rgb{1, 1, 1});
}

// Into the frame of the brushing, and back.
Vec3 Turned(const PrincipledParams& params, const Vec3& w) {
  const float c = params.layers->cos_rotation, s = params.sin_rotation;
  return {c * w.x + s * w.y, c * w.y - s * w.x, w.z};
}
Vec3 TurnedBack(const PrincipledParams& params, const Vec3& w) {
  const float c = params.layers->cos_rotation, s = params.sin_rotation;
  return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

Ggx CoatSurface(const PrincipledParams& params) {
  return {params.coat_alpha, params.coat_alpha};
}

BaseEnergy::Place PlaceOf(const PrincipledParams& params) {
  return {params.row, params.brushing};
}

/// What the layers reflect of the light from a direction, each of what it gets. Layers that are not
/// there reflect nothing.
struct Shares {
  float sheen = 0, coat = 0, dielectric = 0, metal = 0;
};

Shares SharesAt(const PrincipledParams& params, const Vec3& w) {
  const PrincipledLayers& layers = *params.layers;
  Shares shares;
  if (params.sheen != Rgb()) {
    const float largest = std::max(params.sheen.x, std::max(params.sheen.y, params.sheen.z));
    shares.sheen = largest * layers.sheen->At(w.z, params.sheen_roughness);
  }
  if (params.coat > 0) shares.coat = params.coat * layers.coat->At(w.z, params.coat_row);
  const BaseEnergy::Place place = PlaceOf(params);
  const float row = layers.metal->RowOf(place, w);
  if (params.metallic < 1) shares.dielectric = layers.dielectric->At(place, w.z, row);
  if (params.metallic > 0) shares.metal = layers.metal->At(place, w.z, row);
  return shares;
}

/// What gets to the ground.
Spectrum LetThrough(const PrincipledParams& params, const Shares& shares) {
  return (Spectrum(1) - Spectrum(params.specular) * shares.dielectric) * (1 - shares.coat);
}

/// Schlick, "An Inexpensive BRDF Model for Physically-Based Rendering", 1994.
Spectrum MetalReflectance(const Spectrum& head_on, float cosine) {
  const float c = 1 - cosine, c2 = c * c;
  return head_on + (White() - head_on) * (c2 * c2 * c);
}

/// The value of a rough surface that mirrors all light by facets with the normal `m`, and the
/// density with which those are drawn, per direction that they send light to.
struct Mirrored {
  float value, pdf;
};

Mirrored MirroredBy(const Ggx& surface, const Vec3& wo, const Vec3& wi, const Vec3& m) {
  const float seen = surface.Density(m) / (4 * wo.z);
  const float hidden = surface.Lambda(wo);
  return {seen / ((1 + hidden + surface.Lambda(wi)) * wi.z), seen / (1 + hidden)};
}

/// How often each way to draw a direction is taken.
struct Choices {
  float sheen, coat, mirrored, multiple, ground;
};

Choices ChoicesAt(const Lobe& lobe, const Shares& shares) {
  const PrincipledParams& params = lobe.principled;
  const float m = params.metallic;
  const float beneath = (1 - shares.sheen) * (1 - shares.coat);
  Choices choices{shares.sheen, (1 - shares.sheen) * shares.coat, 0, 0, 0};
  if (m < 1) {
    choices.mirrored += (1 - m) * Spectrum(params.specular).MaxComponent() * shares.dielectric;
    choices.ground = (1 - m) * lobe.weight.MaxComponent() * (1 - shares.sheen) *
                     LetThrough(params, shares).MaxComponent();
  }
  if (m > 0) {
    const float metal = std::max(lobe.weight.MaxComponent(), 1.0f / 21);
    choices.mirrored += m * shares.metal * metal;
    choices.multiple = beneath * m * (1 - shares.metal);
  }
  choices.mirrored *= beneath;
  const float sum =
      choices.sheen + choices.coat + choices.mirrored + choices.multiple + choices.ground;
  const float scale = sum > 0 ? 1 / sum : 0;
  return {choices.sheen * scale, choices.coat * scale, choices.mirrored * scale,
          choices.multiple * scale, choices.ground * scale};
}

// The functions below take directions in the frame of the brushing.

LobeValue ValueAndPdf(const Lobe& lobe, const Vec3& wo, const Shares& at_o, const Choices& choices,
                      const Vec3& wi) {
  const PrincipledParams& params = lobe.principled;
  const PrincipledLayers& layers = *params.layers;
  const Shares at_i = SharesAt(params, wi);
  const float m = params.metallic;

  const Vec3 half = wo + wi;
  const float length = Length(half);
  const Vec3 facet = half * (1 / length);
  // Half of the length is the cosine of both to the facet, with the same rounding.
  const float cosine = std::min(length / 2, 1.0f);
  float beyond;

  Spectrum reflectance, value;
  float pdf = choices.ground * CosineHemispherePdf(wi.z) + choices.sheen * UniformHemispherePdf();
  if (m < 1) {
    reflectance =
        Spectrum(params.specular) * ((1 - m) * DielectricReflectance(cosine, layers.eta, &beyond));
    value = Spectrum(params.ground) * LetThrough(params, at_o) * LetThrough(params, at_i);
  }
  const float below_coat = std::min(1 - at_o.coat, 1 - at_i.coat);
  if (m > 0) {
    reflectance += MetalReflectance(lobe.weight, cosine) * m;
    const float missing = (1 - at_o.metal) * (1 - at_i.metal);
    value += Spectrum(params.multiple) * (missing * below_coat);
    pdf += choices.multiple * layers.metal->MissingPdf(PlaceOf(params), wi.z);
  }
  const Mirrored base = MirroredBy(params.surface, wo, wi, facet);
  value += reflectance * (below_coat * base.value);
  pdf += choices.mirrored * base.pdf;
  if (params.coat > 0) {
    const Mirrored coat = MirroredBy(CoatSurface(params), wo, wi, facet);
    const float fresnel = DielectricReflectance(cosine, PrincipledLayers::kCoatIndex, &beyond);
    value += White() * (params.coat * fresnel * coat.value);
    pdf += choices.coat * coat.pdf;
  }
  if (params.sheen != Rgb()) {
    value *= Spectrum(std::min(1 - at_o.sheen, 1 - at_i.sheen));
    value += Spectrum(params.sheen) * layers.sheen->Value(params.sheen_roughness, wo, wi);
  }
  return {value, pdf};
}

Vec3 Draw(const Lobe& lobe, const Choices& choices, const Vec3& wo, Vec2 u) {
  const PrincipledParams& params = lobe.principled;
  float left = 1;
  const auto is_chosen = [&](float choice) {
    if (!(choice > 0)) return false;
    const bool is_it = SplitChoice(std::min(choice / left, 1.0f), &u.x);
    left -= choice;
    return is_it;
  };
  if (is_chosen(choices.sheen)) return SampleUniformHemisphere(u);
  if (is_chosen(choices.multiple)) {
    return params.layers->metal->SampleMissing(PlaceOf(params), u);
  }
  const bool is_coat = is_chosen(choices.coat);
  // The last one takes what rounding has left.
  if (is_coat || choices.ground == 0 || is_chosen(choices.mirrored)) {
    const Ggx surface = is_coat ? CoatSurface(params) : params.surface;
    const Vec3 m = surface.SampleVisible(wo, u);
    return m * (2 * Dot(wo, m)) - wo;
  }
  return SampleCosineHemisphere(u);
}

}  // namespace

Spectrum EvalPrincipled(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return EvalPrincipledWithPdf(lobe, wo, wi).value;
}

float PrincipledPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return EvalPrincipledWithPdf(lobe, wo, wi).pdf;
}

LobeValue EvalPrincipledWithPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const Vec3 o = Turned(lobe.principled, wo);
  const Shares shares = SharesAt(lobe.principled, o);
  return ValueAndPdf(lobe, o, shares, ChoicesAt(lobe, shares), Turned(lobe.principled, wi));
}

LobeSample SamplePrincipled(const Lobe& lobe, Vec3 wo, Vec2 u) {
  const Vec3 o = Turned(lobe.principled, wo);
  const Shares shares = SharesAt(lobe.principled, o);
  const Choices choices = ChoicesAt(lobe, shares);
  const Vec3 i = Draw(lobe, choices, o, u);
  if (!(i.z > 0)) return {};
  const LobeValue drawn = ValueAndPdf(lobe, o, shares, choices, i);
  if (!(drawn.pdf > 0)) return {};
  LobeSample sample;
  sample.pdf = drawn.pdf;
  sample.weight = drawn.value * (i.z / drawn.pdf);
  sample.wi = TurnedBack(lobe.principled, i);
  return sample;
}

}  // namespace candela
