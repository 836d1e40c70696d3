#pragma once

#include "lights/light_choice.h"

namespace candela {

/// How `PathIntegrator` looks for light. But for `lift` and `beyond_light_paths` all ways have the
/// same mean: they are there for tests and comparisons.
struct PathTechniques {
  /// How what a sampled light gives and what a ray finds are combined, where both can be the same.
  enum class Weights { kPowerHeuristic, kBalanceHeuristic };

  bool next_event = true;  ///< Lights that rays can find are sampled as well.
  bool roulette = true;    ///< Long paths may end early.
  /// Light meets meshes with smooth normals as if they were round, not in the shadow of their own
  /// triangles. Without this, the mean is another one.
  bool lift = true;
  /// Only what light paths cannot bring to the camera: lights that it sees directly, what the
  /// surface that it sees sends on in a single direction, and what it sees through holes of that
  /// surface, or beyond one that lies hidden in another body. Then the rest is left out of the
  /// mean.
  bool beyond_light_paths = false;
  Weights weights = Weights::kPowerHeuristic;
  LightChoice light_choice = LightChoice::kByEffect;
};

}  // namespace candela
