#pragma once

#include "math/vec.h"

namespace candela {

/// A rough surface of facets whose slopes have the GGX distribution, with the height-correlated
/// masking and shadowing of Smith: Walter et al., "Microfacet Models for Refraction through Rough
/// Surfaces", 2007; Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based
/// BRDFs", 2014. Directions are unit vectors of a frame whose z axis is the mean normal.
struct Ggx {
  float alpha_x, alpha_y;  ///< Roughness along either axis, above 0.

  /// The density of facet normals `m`, per steradian and area: the projected area integrates to 1.
  float Density(Vec3 m) const;

  /// Hidden area over visible area, as seen from `w`.
  float Lambda(Vec3 w) const;

  /// The share of the facets that `w` sees, and that both directions see.
  float Masking(Vec3 w) const { return 1 / (1 + Lambda(w)); }
  float MaskingAndShadowing(Vec3 wo, Vec3 wi) const { return 1 / (1 + Lambda(wo) + Lambda(wi)); }

  /// Draws a normal in proportion to the area of its facets as seen from `wo`, whose z is not
  /// negative: Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023.
  Vec3 SampleVisible(Vec3 wo, Vec2 u) const;

  /// The density of those normals, per steradian.
  float VisibleDensity(Vec3 wo, Vec3 m) const;
};

/// A surface of so little roughness is taken as polished: its facets would be lost in rounding.
inline constexpr float kSmoothestAlpha = 1e-3f;

}  // namespace candela
