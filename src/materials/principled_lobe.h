#pragma once

#include "materials/lobe.h"

namespace candela {

/// What is opaque of a `principled` surface: metal and a dielectric over a diffuse ground, finely
/// mixed, under a clear coat, under fuzz. After Burley, "Physically Based Shading at Disney", 2012,
/// and the metallic-roughness model of glTF 2.0, but without loss or gain where these have some:
/// light that met several facets of metal is added (see `EnergyTable`), the ground gets what the
/// layers above let through (see `EvalPlastic`), and what is mirrored below the coat or the fuzz is
/// scaled by the lesser of what these let through on either way (Estevez and Kulla, "Production
/// Friendly Microfacet Sheen BRDF", 2017). Symmetric.
Spectrum EvalPrincipled(const Lobe& lobe, Vec3 wo, Vec3 wi);
float PrincipledPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeValue EvalPrincipledWithPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SamplePrincipled(const Lobe& lobe, Vec3 wo, Vec2 u);

}  // namespace candela
