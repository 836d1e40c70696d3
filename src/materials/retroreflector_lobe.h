#pragma once

#include "materials/lobe.h"

namespace candela {

/// Sends light back to where it came from, more or less exactly: a rough mirror that loses nothing,
/// seen from the mirrored direction: the back-vector model of Belcour et al., "Bi-directional
/// Retroreflection: Measurements and Models of Retroreflective Materials", 2014. Its parameters are
/// those of such a conductor, and its share of light is the same.
Spectrum EvalRetroreflector(const Lobe& lobe, Vec3 wo, Vec3 wi);
float RetroreflectorPdf(const Lobe& lobe, Vec3 wo, Vec3 wi);
LobeSample SampleRetroreflector(const Lobe& lobe, Vec3 wo, Vec2 u);

}  // namespace candela
