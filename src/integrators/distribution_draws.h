#pragma once

#include <cstdint>

#include "math/vec.h"

namespace candela {

// What a tree of rays needs to draw its branches.

/// Where a ray of the tree comes from.
enum class Branch : uint32_t {
  kReflection = 1,
  kRefraction = 2,
  kGathering = 3,
  kFirstLight = 4,  ///< To a lamp; the others of the scene follow.
};

/// The name of a ray's random numbers, from that of the ray before. Names far apart in the tree may
/// be the same by chance, once in 268 million times.
uint32_t NameOf(uint32_t parent, uint32_t branch);

/// A direction about the unit vector `axis`, with the density of a power of the cosine to it: the
/// Phong highlight that looks as wide as that of facets whose alpha is the square of `roughness`.
/// The axis itself for 0.
Vec3 SampleAbout(Vec3 axis, float roughness, Vec2 u);

/// What becomes of light at a smooth boundary.
struct Refraction {
  float reflectance;  ///< 1 beyond the critical angle.
  Vec3 direction;     ///< A unit vector; means nothing when everything is reflected.
};

/// Along the unit vector `d` against the unit normal `n`, into a medium whose refractive index is
/// `eta` times that of its own.
Refraction Refract(Vec3 d, Vec3 n, float eta);

}  // namespace candela
