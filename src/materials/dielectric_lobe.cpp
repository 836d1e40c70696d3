#include "materials/dielectric_lobe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "materials/energy_table.h"
#include "materials/fresnel.h"
#include "materials/thin_film.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr auto kInvPi = static_cast<float>(1 / kPi);

Vec3 Reflected(Vec3 w, Vec3 m) {
  return m * (2 * Dot(w, m)) - w;
}

/// Into the medium of `eta` times the index, where the cosine to -m is `cos_beyond`: Snell's law.
Vec3 Refracted(Vec3 w, Vec3 m, float eta, float cos_beyond) {
  return Normalize(m * (Dot(w, m) / eta - cos_beyond) - w * (1 / eta));
}

/// A number in [0, 1) without relation to the pair that it is made of: the facet takes all of that,
/// and what happens on it is known only then. By the finaliser of Steele, Lea and Flood, "Fast
/// Splittable Pseudorandom Number Generators", 2014.
float ThirdNumber(Vec2 u) {
  uint64_t bits = uint64_t{std::bit_cast<uint32_t>(u.x)} << 32 | std::bit_cast<uint32_t>(u.y);
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  bits ^= bits >> 31;
  return static_cast<float>(bits >> 40) * 0x1p-24f;
}

/// Like `DielectricReflectance`, for a boundary with a film. A film that absorbs nothing reflects
/// the same from both sides, so it is looked up from the one where nothing is reflected wholly.
Rgb FilmedReflectance(const FilmParams& film, float cosine, float eta, float* beyond) {
  const float bare = DielectricReflectance(cosine, eta, beyond);
  const bool is_whole = *beyond == 0;
  if (is_whole) return {1, 1, 1};
  const float outside = eta < 1 ? *beyond : cosine;
  if (film.wavelength == 0) return film.table->Over({bare, bare, bare}, outside, film.row);
  const FilmStack stack{double{film.ior} / double{film.outside},
                        {double{eta < 1 ? 1 / eta : eta}, 0},
                        double{film.outside}};
  const auto reflectance = static_cast<float>(
      FilmReflectance(stack, double{film.thickness}, double{film.wavelength}, double{outside}));
  return {reflectance, reflectance, reflectance};
}

float MeanOf(Rgb c) {
  return (c.x + c.y + c.z) / 3;
}

/// The energies of light from one side, between those of two indices where there are two.
class SideEnergy {
 public:
  static SideEnergy Here(const DielectricParams& glass) {
    return {glass.energy_here, glass.next_here, glass.next_part, glass.table_row};
  }
  static SideEnergy Beyond(const DielectricParams& glass) {
    return {glass.energy_beyond, glass.next_beyond, glass.next_part, glass.table_row};
  }

  float At(float cosine) const {
    return Blend([&](const EnergyTable& table) { return table.At(cosine, row_); });
  }
  float Mean() const {
    return Blend([&](const EnergyTable& table) { return table.Mean(row_); });
  }
  float MissingPdf(float cosine) const {
    return Blend([&](const EnergyTable& table) { return table.MissingPdf(cosine, row_); });
  }
  Vec3 SampleMissing(Vec2 u) const {
    const bool is_next = part_ > 0 && SplitChoice(part_, &u.x);
    return (is_next ? next_ : first_)->SampleMissing(row_, u);
  }

  /// How densely light that met several facets leaves over its cosine, as a part of what leaves on
  /// this side.
  float MultipleShape(float cosine) const {
    const float missing = 1 - Mean();
    return missing > 1e-7f ? (1 - At(cosine)) * kInvPi / missing : 0;
  }

 private:
  SideEnergy(const EnergyTable* first, const EnergyTable* next, float part, float row)
      : first_(first), next_(next), part_(part), row_(row) {}

  template <class Value>
  float Blend(const Value& value) const {
    const float first = value(*first_);
    return part_ == 0 ? first : first * (1 - part_) + value(*next_) * part_;
  }

  const EnergyTable *first_, *next_;
  float part_, row_;
};

/// The share of the light on `wo` that is gone after one bounce.
float SingleShare(const DielectricParams& glass, Vec3 wo) {
  return SideEnergy::Here(glass).At(wo.z);
}

/// Of the light that has met several facets, the part that is reflected.
float MultipleReflected(const DielectricParams& glass) {
  const float here = 1 - SideEnergy::Here(glass).Mean();
  const float beyond = 1 - SideEnergy::Beyond(glass).Mean();
  const float weight_beyond = glass.eta * glass.eta * beyond;
  const float sum = here + weight_beyond;
  return sum > 0 ? here / sum : 1;
}

float MultipleValue(const DielectricParams& glass, Vec3 wo, Vec3 wi) {
  const float missing = 1 - SingleShare(glass, wo);
  const float reflected = MultipleReflected(glass);
  if (wi.z > 0) {
    return missing * reflected * SideEnergy::Here(glass).MultipleShape(wi.z);
  }
  return missing * (1 - reflected) / (glass.eta * glass.eta) *
         SideEnergy::Beyond(glass).MultipleShape(-wi.z);
}

/// What a pair of directions means for a rough boundary; `is_possible` is false where no facet
/// leads from one to the other.
struct FacetPath {
  bool is_possible = false;
  Vec3 m;
  float o_dot_m = 0, i_dot_m = 0;
  float reflectance = 0;  ///< By which it is drawn: under a film the mean of the colours.
  Rgb by_colour;          ///< Under a film.
  float jacobian = 0;     ///< Density of `wi` over that of `m`.
};

FacetPath PathOver(const DielectricParams& glass, Vec3 wo, Vec3 wi) {
  FacetPath path;
  const bool is_reflection = wi.z > 0;
  const Vec3 half = is_reflection ? wo + wi : wo + wi * glass.eta;
  const float length = Length(half);
  if (!(length > 0)) return path;
  path.m = half * (1 / length);
  if (path.m.z < 0) path.m = -path.m;
  // In reflection half of the length is the cosine of both, with the same rounding.
  path.o_dot_m = is_reflection ? length / 2 : Dot(wo, path.m);
  path.i_dot_m = is_reflection ? length / 2 : Dot(wi, path.m);
  // A facet is seen from its front by one and, in refraction, from its back by the other.
  if (!(path.o_dot_m > 0) || (path.i_dot_m > 0) != is_reflection) return path;
  // What goes through is judged from the thinner side, where the reflectance has no steep end.
  const bool is_from_beyond = !is_reflection && glass.eta < 1;
  const float cosine = is_from_beyond ? -path.i_dot_m : path.o_dot_m;
  const float eta = is_from_beyond ? 1 / glass.eta : glass.eta;
  float unused;
  if (glass.film.table) {
    path.by_colour = FilmedReflectance(glass.film, std::min(cosine, 1.0f), eta, &unused);
    path.reflectance = MeanOf(path.by_colour);
  } else {
    path.reflectance = DielectricReflectance(std::min(cosine, 1.0f), eta, &unused);
  }
  if (is_reflection) {
    path.jacobian = 1 / (4 * path.o_dot_m);
  } else {
    const float denominator = path.i_dot_m + path.o_dot_m / glass.eta;
    path.jacobian = std::abs(path.i_dot_m) / (denominator * denominator);
  }
  path.is_possible = true;
  return path;
}

float SingleDensity(const DielectricParams& glass, const FacetPath& path, Vec3 wo, Vec3 wi) {
  if (!path.is_possible) return 0;
  const float choice = wi.z > 0 ? path.reflectance : 1 - path.reflectance;
  return choice * glass.surface.VisibleDensity(wo, path.m) * path.jacobian;
}

float DensityOf(const DielectricParams& glass, const FacetPath& path, Vec3 wo, Vec3 wi) {
  const float share = SingleShare(glass, wo);
  const float reflected = MultipleReflected(glass);
  const float multiple = wi.z > 0 ? reflected * SideEnergy::Here(glass).MissingPdf(wi.z)
                                  : (1 - reflected) * SideEnergy::Beyond(glass).MissingPdf(-wi.z);
  return share * SingleDensity(glass, path, wo, wi) + (1 - share) * multiple;
}

float SingleValue(const DielectricParams& glass, const FacetPath& path, Vec3 wo, Vec3 wi) {
  if (!path.is_possible) return 0;
  const float facets = glass.surface.Density(path.m) * glass.surface.MaskingAndShadowing(wo, wi) /
                       (wo.z * std::abs(wi.z));
  if (wi.z > 0) return path.reflectance * facets / 4;
  return (1 - path.reflectance) * facets * path.o_dot_m * path.jacobian / (glass.eta * glass.eta);
}

float Value(const DielectricParams& glass, const FacetPath& path, Vec3 wo, Vec3 wi) {
  return SingleValue(glass, path, wo, wi) + MultipleValue(glass, wo, wi);
}

/// The boundary as one of three colours meets it.
DielectricParams OfColour(const DielectricParams& glass, int colour) {
  DielectricParams single = glass;
  single.energy_here += colour - 1;
  single.energy_beyond += colour - 1;
  return single;
}

/// The value for a direction, with the colours of a film.
Spectrum ValueByColour(const DielectricParams& glass, const FacetPath& path, Vec3 wo, Vec3 wi) {
  const bool is_coloured = glass.film.table && glass.film.wavelength == 0;
  if (!is_coloured) return Spectrum(Value(glass, path, wo, wi));
  Rgb values;
  FacetPath single = path;
  for (int c = 0; c < 3; ++c) {
    single.reflectance = path.by_colour[c];
    values[c] = Value(OfColour(glass, c), single, wo, wi);
  }
  return Spectrum(values);
}

/// A value for a direction, with the colour of what goes through.
Spectrum Coloured(const Lobe& lobe, const Spectrum& value, Vec3 wi) {
  return wi.z > 0 ? value : lobe.weight * value;
}

float RefractedShare(float eta, const Ggx& surface, Vec3 wo, Vec3 m, float cos_beyond) {
  const Vec3 wi = Refracted(wo, m, eta, cos_beyond);
  if (!(wi.z < 0)) return 0;
  return surface.MaskingAndShadowing(wo, wi) / surface.Masking(wo);
}

/// What a facet gives back, where the cosine to its back of what it refracts is `beyond`.
float FacetShare(float reflectance, float eta, const Ggx& surface, Vec3 wo, Vec3 m, float beyond) {
  float share = reflectance * MirrorFacet(surface, wo, m);
  if (reflectance < 1) share += (1 - reflectance) * RefractedShare(eta, surface, wo, m, beyond);
  return share;
}

/// Polished glass under a film, which reflects each colour differently.
LobeSample SampleFilm(const Lobe& lobe, Vec3 wo, Vec2 u) {
  const float eta = lobe.dielectric.eta;
  float beyond;
  const Rgb reflectance =
      FilmedReflectance(lobe.dielectric.film, std::min(wo.z, 1.0f), eta, &beyond);
  const float mean = MeanOf(reflectance);
  LobeSample sample;
  sample.is_delta = true;
  if (u.x < mean) {
    sample.wi = MirrorDirection(wo);
    sample.pdf = mean;
    sample.weight = Spectrum(reflectance * (1 / mean));
  } else {
    sample.wi = Refracted(wo, {0, 0, 1}, eta, beyond);
    sample.pdf = 1 - mean;
    const Rgb through = Rgb{1, 1, 1} - reflectance;
    sample.weight = lobe.weight * Spectrum(through * (1 / (sample.pdf * eta * eta)));
    sample.eta = eta;
  }
  return sample;
}

Rgb Exp(Rgb x) {
  return {candela::Exp(x.x), candela::Exp(x.y), candela::Exp(x.z)};
}

}  // namespace

LobeSample SampleSmoothDielectric(const Lobe& lobe, Vec3 wo, Vec2 u) {
  if (lobe.dielectric.film.table) return SampleFilm(lobe, wo, u);
  const float eta = lobe.dielectric.eta;
  float beyond;
  const float reflectance = DielectricReflectance(std::min(wo.z, 1.0f), eta, &beyond);
  LobeSample sample;
  sample.is_delta = true;
  if (u.x < reflectance) {
    sample.wi = MirrorDirection(wo);
    sample.pdf = reflectance;
    sample.weight = Spectrum(1);
  } else {
    sample.wi = Refracted(wo, {0, 0, 1}, eta, beyond);
    sample.pdf = 1 - reflectance;
    sample.weight = lobe.weight * (1 / (eta * eta));
    sample.eta = eta;
  }
  return sample;
}

Spectrum EvalDielectric(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  const FacetPath path = PathOver(lobe.dielectric, wo, wi);
  return Coloured(lobe, ValueByColour(lobe.dielectric, path, wo, wi), wi);
}

float DielectricPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return DensityOf(lobe.dielectric, PathOver(lobe.dielectric, wo, wi), wo, wi);
}

LobeSample SampleDielectric(const Lobe& lobe, Vec3 wo, Vec2 u) {
  const DielectricParams& glass = lobe.dielectric;
  LobeSample sample;
  bool is_reflection;
  if (SplitChoice(SingleShare(glass, wo), &u.x)) {
    const Vec3 m = glass.surface.SampleVisible(wo, u);
    const float cosine = std::min(Dot(wo, m), 1.0f);
    float beyond;
    const float reflectance =
        glass.film.table ? MeanOf(FilmedReflectance(glass.film, cosine, glass.eta, &beyond))
                         : DielectricReflectance(cosine, glass.eta, &beyond);
    is_reflection = ThirdNumber(u) < reflectance;
    sample.wi = is_reflection ? Reflected(wo, m) : Refracted(wo, m, glass.eta, beyond);
  } else {
    is_reflection = SplitChoice(MultipleReflected(glass), &u.x);
    const SideEnergy side = is_reflection ? SideEnergy::Here(glass) : SideEnergy::Beyond(glass);
    sample.wi = side.SampleMissing(u);
    if (!is_reflection) sample.wi.z = -sample.wi.z;
  }
  if (is_reflection ? !(sample.wi.z > 0) : !(sample.wi.z < 0)) return {};
  const FacetPath path = PathOver(glass, wo, sample.wi);
  sample.pdf = DensityOf(glass, path, wo, sample.wi);
  if (!(sample.pdf > 0)) return {};
  const Spectrum value = ValueByColour(glass, path, wo, sample.wi);
  const Spectrum weight = value * std::abs(sample.wi.z) / Spectrum(sample.pdf);
  sample.weight = Coloured(lobe, weight, sample.wi);
  if (!is_reflection) sample.eta = glass.eta;
  return sample;
}

float CoatFacet(float eta, const Ggx& surface, Vec3 wo, Vec3 m) {
  float beyond;
  return DielectricReflectance(std::min(Dot(wo, m), 1.0f), eta, &beyond) *
         MirrorFacet(surface, wo, m);
}

float DielectricFacet(float eta, const Ggx& surface, Vec3 wo, Vec3 m) {
  float beyond;
  const float reflectance = DielectricReflectance(std::min(Dot(wo, m), 1.0f), eta, &beyond);
  return FacetShare(reflectance, eta, surface, wo, m, beyond);
}

float FilmFacet(const DielectricParams& glass, int colour, const Ggx& surface, Vec3 wo, Vec3 m) {
  float beyond;
  const Rgb reflectance =
      FilmedReflectance(glass.film, std::min(Dot(wo, m), 1.0f), glass.eta, &beyond);
  return FacetShare(reflectance[colour], glass.eta, surface, wo, m, beyond);
}

// With the reflectance R of one face and the transmittance a of the way between them, the rays that
// leave on either side form geometric series: R + R (1 - R)^2 a^2 / (1 - R^2 a^2), and
// (1 - R)^2 a / (1 - R^2 a^2).
PaneShares SharesOfPane(const PaneParams& pane, float cosine) {
  float inside;
  const float r = DielectricReflectance(std::min(cosine, 1.0f), pane.ior, &inside);
  const Rgb a = Exp(pane.depth * (-1 / inside));
  const auto channel = [r](float t, float* reflected, float* through) {
    const float series = (1 - r) * (1 - r) * t / std::max(1 - r * r * t * t, 1e-7f);
    *through = series;
    *reflected = r + r * t * series;
  };
  PaneShares shares;
  channel(a.x, &shares.reflected.x, &shares.through.x);
  channel(a.y, &shares.reflected.y, &shares.through.y);
  channel(a.z, &shares.reflected.z, &shares.through.z);
  return shares;
}

LobeSample SamplePane(const Lobe& lobe, Vec3 wo, Vec2 u) {
  const PaneShares shares = SharesOfPane(lobe.pane, wo.z);
  const float reflected = shares.reflected.x + shares.reflected.y + shares.reflected.z;
  const float through = shares.through.x + shares.through.y + shares.through.z;
  LobeSample sample;
  sample.is_delta = true;
  if (!(reflected + through > 0)) return sample;
  const float choice = reflected / (reflected + through);
  const bool is_reflection = u.x < choice;
  sample.wi = is_reflection ? MirrorDirection(wo) : -wo;
  sample.pdf = is_reflection ? choice : 1 - choice;
  const Rgb share = is_reflection ? shares.reflected : shares.through;
  sample.weight = lobe.weight * Spectrum(share * (1 / sample.pdf));
  return sample;
}

}  // namespace candela
