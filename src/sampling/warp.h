#pragma once

#include <span>

#include "math/elementary.h"
#include "math/vec.h"

namespace candela {

// Maps from the unit square to disks and directions. Each comes as three functions: `Sample...`
// takes a pair in [0, 1)^2, `...Pdf` is the density of the result over area or solid angle, and
// `Invert...` gives the pair back to about 1e-6. Directions are unit vectors of a local frame whose
// normal is z. Neighbouring pairs give neighbouring results, so evenly spread pairs stay evenly
// spread.

/// The unit disk, by area. The square's rings around its centre become the disk's rings (P. Shirley
/// and K. Chiu, "A low distortion map between disk and square", 1997).
Vec2 SampleDisk(Vec2 u);
Vec2 InvertDisk(Vec2 p);
constexpr float DiskPdf() {
  return static_cast<float>(1 / kPi);
}

/// The upper hemisphere with density cos / pi: the disk, lifted to the sphere (Malley's method).
/// The rim, where the cosine and with it the density is 0, is a possible result.
Vec3 SampleCosineHemisphere(Vec2 u);
/// The same for many pairs, in lists of one size, at a fraction of the time.
void SampleCosineHemisphere(std::span<const Vec2> u, std::span<Vec3> directions);
Vec2 InvertCosineHemisphere(Vec3 direction);
/// 0 for directions below the horizon.
constexpr float CosineHemispherePdf(float cosine) {
  return cosine > 0 ? cosine * static_cast<float>(1 / kPi) : 0;
}

/// All directions of the upper hemisphere, and of the whole sphere, with equal density: heights are
/// uniform by Archimedes' theorem.
Vec3 SampleUniformHemisphere(Vec2 u);
Vec2 InvertUniformHemisphere(Vec3 direction);
constexpr float UniformHemispherePdf() {
  return static_cast<float>(1 / (2 * kPi));
}

Vec3 SampleUniformSphere(Vec2 u);
Vec2 InvertUniformSphere(Vec3 direction);
constexpr float UniformSpherePdf() {
  return static_cast<float>(1 / (4 * kPi));
}

/// Directions within an angle around z, with equal density. The angle is given by 1 - its cosine,
/// so that the narrowest cones keep their digits.
Vec3 SampleCone(Vec2 u, float one_minus_cosine);
Vec2 InvertCone(Vec3 direction, float one_minus_cosine);
constexpr float ConePdf(float one_minus_cosine) {
  return static_cast<float>(1 / (2 * kPi)) / one_minus_cosine;
}

/// Barycentric weights of the second and the third corner of a triangle, by area: E. Heitz, "A Low-
/// Distortion Map Between Triangle and Square", 2019. The density over area is 1 / area.
Vec2 SampleTriangle(Vec2 u);
Vec2 InvertTriangle(Vec2 weights);

}  // namespace candela
