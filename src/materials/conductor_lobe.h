#pragma once

#include "materials/lobe.h"

namespace candela {

/// What a metal reflects at a cosine to its normal, under a film or bare.
Rgb MetalReflectance(Rgb eta, Rgb k, const FilmParams& film, float cosine);

/// A polished metal.
LobeSample SampleSmoothConductor(const Lobe& lobe, Vec3 wo);

/// A rough metal: facets of `Ggx`, and a diffuse term for light that has met several of them; see
/// `EnergyTable`.
Spectrum EvalConductor(const Lobe& lobe, Vec3 wo, Vec3 wi);
float ConductorPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SampleConductor(const Lobe& lobe, Vec3 wo, Vec2 u);

}  // namespace candela
