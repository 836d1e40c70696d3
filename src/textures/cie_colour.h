#pragma once

#include "math/vec.h"

namespace candela {

/// How strongly the eye of the CIE's standard observer of 1931 answers to light of a wavelength in
/// nanometres: x, y and z, of which y is luminous efficiency. By the sums of Gaussians of C. Wyman,
/// P.-P. Sloan, P. Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching
/// Functions", JCGT 2013; within about one percent of the largest value.
Vec3d ColourMatching(double nanometres);

/// The linear colour of the primaries and the white of sRGB (IEC 61966-2-1) of a colour X, Y, Z.
/// May be negative for colours that no screen shows.
Vec3 RgbOfXyz(Vec3d xyz);

}  // namespace candela
