#pragma once

#include <algorithm>
#include <limits>

#include "math/spectrum.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// How the light of a lamp without extent loses by the distance D: it gives its colour over
/// (constant + linear D + quadratic D^2). Light itself knows the last of these alone, and then the
/// colour over `quadratic` is an intensity; with the others lamps stay bright from afar as early
/// graphics wanted them: Foley, van Dam, Feiner, Hughes, "Computer Graphics: Principles and
/// Practice", 1990, section 16.1.
struct Falloff {
  /// That of light.
  Falloff(float attenuation) : quadratic(attenuation) {}  // NOLINT: an attenuation is a falloff.
  Falloff(float constant_, float linear_, float quadratic_)
      : constant(constant_), linear(linear_), quadratic(quadratic_) {}

  /// Reads the parameter `attenuation`, or `falloff`, which may stand in its place.
  static Falloff Read(ParamReader* params);

  float constant = 0, linear = 0, quadratic;  ///< Not negative, and one of them above 0.

  bool IsOfLight() const { return constant + linear == 0; }

  /// What the colour is divided by.
  float At(float distance, float squared_distance) const {
    if (IsOfLight()) return quadratic * squared_distance;
    // Parts that are 0 stay so, however far it is: 0 times infinity is no number.
    const float by_distance = linear > 0 ? linear * distance : 0;
    const float by_square = quadratic > 0 ? quadratic * squared_distance : 0;
    return constant + by_distance + by_square;
  }

  /// By which the colour is divided where lights are compared from afar, as if it was an intensity:
  /// what a distance of 1 makes of it. The quadratic part alone would not do, since a small one
  /// beside others says nothing of how bright the lamp is. Finite, so that no lamp looks dark.
  float ForComparison() const {
    return std::min(constant + linear + quadratic, std::numeric_limits<float>::max());
  }
};

}  // namespace candela
