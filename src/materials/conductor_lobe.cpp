#include "materials/conductor_lobe.h"

#include <algorithm>
#include <cmath>

#include "materials/energy_table.h"
#include "materials/fresnel.h"
#include "materials/thin_film.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr auto kInvPi = static_cast<float>(1 / kPi);

// Into the frame of the brushing, and back.
Vec3 Turned(const ConductorParams& metal, Vec3 w) {
  const float c = metal.cos_rotation, s = metal.sin_rotation;
  return {c * w.x + s * w.y, c * w.y - s * w.x, w.z};
}
Vec3 TurnedBack(const ConductorParams& metal, Vec3 w) {
  const float c = metal.cos_rotation, s = metal.sin_rotation;
  return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

float RowOf(const ConductorParams& metal, Vec3 w) {
  return metal.is_brushed ? EnergyTable::RowOfAzimuth(w) : metal.table_row;
}

/// The share of the light that is gone after one bounce on a white metal, and of what comes from
/// everywhere.
float SingleShare(const ConductorParams& metal, Vec3 w) {
  return metal.energy->At(w.z, RowOf(metal, w));
}

/// What each further bounce takes of the light that had several of them.
Rgb MultipleColour(Rgb fresnel, float mean_share) {
  const auto channel = [&](float f) { return f * f * mean_share / (1 - f * (1 - mean_share)); };
  return {channel(fresnel.x), channel(fresnel.y), channel(fresnel.z)};
}

// The functions below take directions in the frame of the brushing.

Spectrum Value(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const ConductorParams& metal = lobe.conductor;
  const Vec3 half = wo + wi;
  const float length = Length(half);
  const float single = metal.surface.Density(half * (1 / length)) *
                       metal.surface.MaskingAndShadowing(wo, wi) / (4 * wo.z * wi.z);
  // Half of the length is the cosine of both to the facet, with the same rounding.
  const Rgb fresnel = MetalReflectance(metal.eta, metal.k, metal.film, std::min(length / 2, 1.0f));

  const float mean = metal.energy->Mean(metal.table_row);
  const float missing = (1 - SingleShare(metal, wo)) * (1 - SingleShare(metal, wi));
  const float multiple = missing * kInvPi / std::max(1 - mean, 1e-7f);
  return lobe.weight *
         Spectrum(fresnel * single + MultipleColour(metal.mean_fresnel, mean) * multiple);
}

float Density(const ConductorParams& metal, Vec3 wo, Vec3 wi) {
  const Vec3 m = Normalize(wo + wi);
  const float single = metal.surface.VisibleDensity(wo, m) / (4 * Dot(wo, m));
  const float share = SingleShare(metal, wo);
  return share * single + (1 - share) * metal.energy->MissingPdf(wi.z, metal.table_row);
}

}  // namespace

Rgb MetalReflectance(Rgb eta, Rgb k, const FilmParams& film, float cosine) {
  const Rgb bare = ConductorReflectance(cosine, eta, k);
  return film.table ? film.table->Over(bare, cosine, film.row) : bare;
}

LobeSample SampleSmoothConductor(const Lobe& lobe, Vec3 wo) {
  const ConductorParams& metal = lobe.conductor;
  LobeSample sample;
  sample.wi = MirrorDirection(wo);
  sample.weight = lobe.weight *
                  Spectrum(MetalReflectance(metal.eta, metal.k, metal.film, std::min(wo.z, 1.0f)));
  sample.pdf = 1;
  sample.is_delta = true;
  return sample;
}

Spectrum EvalConductor(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return Value(lobe, Turned(lobe.conductor, wo), Turned(lobe.conductor, wi));
}

float ConductorPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return Density(lobe.conductor, Turned(lobe.conductor, wo), Turned(lobe.conductor, wi));
}

LobeSample SampleConductor(const Lobe& lobe, Vec3 wo, Vec2 u) {
  const ConductorParams& metal = lobe.conductor;
  const Vec3 o = Turned(metal, wo);
  Vec3 i;
  if (SplitChoice(SingleShare(metal, o), &u.x)) {
    const Vec3 m = metal.surface.SampleVisible(o, u);
    i = m * (2 * Dot(o, m)) - o;
  } else {
    i = metal.energy->SampleMissing(metal.table_row, u);
  }
  if (!(i.z > 0)) return {};
  LobeSample sample;
  sample.pdf = Density(metal, o, i);
  if (!(sample.pdf > 0)) return {};
  sample.weight = Value(lobe, o, i) * (i.z / sample.pdf);
  sample.wi = TurnedBack(metal, i);
  return sample;
}

}  // namespace candela
