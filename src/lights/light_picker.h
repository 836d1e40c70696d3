#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lights/light.h"
#include "sampling/alias_table.h"

namespace candela {

/// How a light is chosen for a point.
enum class LightChoice {
  kByEffect,  ///< By what it may give there: its power over the squared distance.
  kUniform,   ///< All alike, for comparison.
};

/// Chooses one of the lights of a scene for a point, from what is known of them from afar. Of few
/// lights by power and distance, and every light keeps a part of the choice, since it may be the
/// only one that nothing hides; of many by power alone. Immutable; called concurrently.
class LightPicker {
 public:
  /// Lights without power are never chosen. `size` is that of the scene: at this distance a light
  /// of the scene counts as much as one infinitely far of the same irradiance.
  LightPicker(std::span<const Light* const> lights, float size, LightChoice choice);

  /// False when there is no choice, so that no number is needed.
  bool NeedsNumber() const { return candidates_.size() > 1; }
  /// False when there is nothing to choose from.
  bool HasLights() const { return !candidates_.empty(); }

  struct Pick {
    uint32_t light;     ///< Index into the lights.
    float probability;  ///< Above 0.
  };
  /// `u` is in [0, 1).
  Pick Choose(Vec3 p, float u) const;
  /// That of a light to be chosen for `p`.
  float Probability(Vec3 p, uint32_t light) const;

 private:
  /// More lights are not looked at one by one for each point.
  static constexpr size_t kFew = 32;
  static constexpr uint32_t kNever = 0xFFFFFFFF;

  struct Candidate {
    uint32_t light;
    LightReach reach;
    float share;  ///< Of the choice that does not ask where the point is.
  };

  /// Roughly the irradiance that a candidate gives to `p`.
  static float Effect(const LightReach& reach, Vec3 p);
  /// Those of all candidates, and their sum.
  float Effects(Vec3 p, std::span<float> effects) const;
  float ProbabilityOf(const Candidate& candidate, float effect, float sum) const;

  std::vector<Candidate> candidates_;
  std::vector<uint32_t> candidate_of_light_;  ///< kNever for those without power.
  bool looks_at_each_ = false;
  std::optional<AliasTable> table_;  ///< Of the shares.
};

}  // namespace candela
