#pragma once

#include "materials/lobe.h"

namespace candela {

// Lobes that spread light widely.

Spectrum EvalLambert(const Lobe& lobe);
LobeSample SampleLambert(const Lobe& lobe, const DirectionNumbers& numbers);

/// The rough diffuse surface of Oren and Nayar in the form of Portsmouth, Kutz and Hill, "EON: A
/// Practical Energy-Preserving Rough Diffuse BRDF", 2025, with their exact albedo.
Spectrum EvalOrenNayar(const Lobe& lobe, Vec3 wo, Vec3 wi);
float OrenNayarPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SampleOrenNayar(const Lobe& lobe, Vec3 wo, Vec2 u);

/// The power cosine lobe around the mirrored direction, such that at normal incidence it reflects
/// the weight, and less elsewhere: Lafortune and Willems, "Using the Modified Phong Reflectance
/// Model for Physically Based Rendering", 1994.
Spectrum EvalPhong(const Lobe& lobe, Vec3 wo, Vec3 wi);
float PhongPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SamplePhong(const Lobe& lobe, Vec3 wo, Vec2 u);

}  // namespace candela
