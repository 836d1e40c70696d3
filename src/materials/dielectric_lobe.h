#pragma once

#include "materials/ggx.h"
#include "materials/lobe.h"

namespace candela {

/// Polished glass: one of the reflected and the refracted ray, by Fresnel's equations.
LobeSample SampleSmoothDielectric(const Lobe& lobe, Vec3 wo, Vec2 u);

/// Ground glass: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007,
/// with a diffuse term for light that has met several facets; see `EnergyTable`. That leaves on
/// either side in proportion to n^2 times what this side misses on average, which is what keeps
/// both directions of light in balance.
Spectrum EvalDielectric(const Lobe& lobe, Vec3 wo, Vec3 wi);
float DielectricPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SampleDielectric(const Lobe& lobe, Vec3 wo, Vec2 u);

/// For the table of energies: what a facet of that index reflects and lets through, the same under
/// the film of `glass` for one of the three colours, and what it reflects alone.
float DielectricFacet(float eta, const Ggx& surface, Vec3 wo, Vec3 m);
float FilmFacet(const DielectricParams& glass, int colour, const Ggx& surface, Vec3 wo, Vec3 m);
float CoatFacet(float eta, const Ggx& surface, Vec3 wo, Vec3 m);

/// A pane with all its inner reflections.
LobeSample SamplePane(const Lobe& lobe, Vec3 wo, Vec2 u);

/// What a pane reflects and lets through of unpolarised light at a cosine to its normal.
struct PaneShares {
  Rgb reflected, through;
};
PaneShares SharesOfPane(const PaneParams& pane, float cosine);

}  // namespace candela
