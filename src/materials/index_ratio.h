#pragma once

#include "materials/medium.h"

namespace candela {

/// Boundaries that hardly refract are taken as polished: there is no telling which facet leads from
/// one direction to the other. Under a film, which reflects nevertheless, they refract so much.
inline constexpr float kLeastContrast = 1e-3f;

/// Whether two indices differ that much.
bool HasContrast(float a, float b);

/// The ratio of two indices for facets under a film, where one is at least that much larger: of
/// equal ones that beyond the boundary, where `is_from_a`, as it is not from the other side.
float FilmedRatio(float here, float beyond, bool is_from_a);

/// The ratio of the index of `b` to that of `a` for all visible light.
struct RatioRange {
  RatioRange(const Medium& a, const Medium& b);

  float Spread() const { return most / least - 1; }
  /// Whether light of some wavelength finds that they differ.
  bool HasContrast() const {
    return candela::HasContrast(1, least) || candela::HasContrast(1, most);
  }
  /// Whether light of some wavelengths enters a thicker medium, and that of others a thinner one.
  bool IsAround1() const { return least < 1 && most > 1; }

  float least, most;
};

/// A measure of ratios around 1: the angle from which all is reflected goes by the root of what the
/// ratio lacks to 1, so tables have even steps of that.
float RootFrom1(float ratio);
float RatioOfRoot(float root);

}  // namespace candela
