#pragma once

#include <vector>

#include "math/vec.h"

namespace candela {

/// Fuzz on a surface: fibres that stand on it, whose normals lie flat: Estevez and Kulla,
/// "Production Friendly Microfacet Sheen BRDF", 2017, with the visibility of Neubelt and Pettineo,
/// "Crafting a Next-Gen Material Pipeline for The Order: 1886", 2013. Where that would reflect more
/// than it gets, for fibres of little roughness at flat angles, all of it is scaled down.
class SheenTable {
 public:
  /// From there to 1; less counts as that.
  static constexpr float kSmoothest = 0.05f;

  /// There is but one, which is made when it is asked for first. May be called concurrently.
  static const SheenTable& Get();

  /// The value for white fibres; directions are those of a frame whose z axis is the normal.
  float Value(float roughness, const Vec3& wo, const Vec3& wi) const;
  /// The share that those reflect of the light at a cosine to the normal.
  float At(float cosine, float roughness) const;

 private:
  SheenTable();
  float ScaleOf(float roughness) const;

  std::vector<float> shares_;  ///< Row after row.
  std::vector<float> scales_;  ///< Of each row.
};

}  // namespace candela
