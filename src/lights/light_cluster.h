#pragma once

#include "geometry/bounds3.h"
#include "lights/light.h"

namespace candela {

/// What is known from afar of lights of the scene taken together: where they are, how much they
/// give, and where to. Each light goes around an axis within a cone, the axes around a common one.
/// A. Conty Estevez and C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree
/// Splitting", 2018.
struct LightCluster {
  Bounds3 box;          ///< Empty while there is no light.
  double power = 0;     ///< The sum of `LightReach::power`.
  Vec3d axis{};         ///< A unit vector; 0 when some light has none.
  double spread = 0;    ///< The largest angle between it and the axis of a light, in radians,
  double cone = 0;      ///< and the largest between the axis of a light and where its light goes.
  bool is_flat = true;  ///< All of them fade with the cosine to their axes.
  bool is_two_sided = true;  ///< All shine along the opposite of their axes as well.

  static LightCluster Of(const LightReach& reach);
  void Add(const LightCluster& other);

  /// How bad it is to have these lights in one: the more they give, the farther they are from each
  /// other, and the more directions they shine into, the worse.
  double Cost() const;

 private:
  void AddAxis(const LightCluster& other);
};

}  // namespace candela
