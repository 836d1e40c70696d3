#pragma once

#include "math/spectrum.h"

namespace candela {

// Fresnel's equations for unpolarised light at a smooth boundary, without approximations: Born and
// Wolf, "Principles of Optics", chapters 1.5 and 14.2. Cosines are those of the angle to the
// normal, from 0 to 1.

/// The reflectance where light comes to a medium whose refractive index is `eta` times that of its
/// own; 1 beyond the critical angle. When something goes through, `*cos_beyond` becomes the cosine
/// of its direction, else 0.
float DielectricReflectance(float cosine, float eta, float* cos_beyond);

/// The same for a metal with the complex refractive index eta + i k in each channel.
Rgb ConductorReflectance(float cosine, Rgb eta, Rgb k);

/// The reflectance for light that comes from everywhere: the mean, weighted by the cosine.
float MeanDielectricReflectance(float eta);
Rgb MeanConductorReflectance(Rgb eta, Rgb k);

}  // namespace candela
