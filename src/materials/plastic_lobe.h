#pragma once

#include "materials/lobe.h"

namespace candela {

/// A diffuse base under a coat of dielectric. What the coat does not reflect gets to the base,
/// between which and the coat's underside it goes to and fro; the weight is the base's albedo. A
/// polished coat is a part of single directions. Symmetric, and without loss over a white base:
/// Kelemen and Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model with Importance
/// Sampling", 2001.
Spectrum EvalPlastic(const Lobe& lobe, Vec3 wo, Vec3 wi);
float PlasticPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SamplePlastic(const Lobe& lobe, Vec3 wo, Vec2 u);

}  // namespace candela
