#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lights/light.h"
#include "lights/light_choice.h"
#include "lights/light_tree.h"
#include "sampling/alias_table.h"

namespace candela {

/// Chooses one of the lights of a scene for a point, from what is known of them from afar: by
/// power, distance, and the way they shine. Few lights are looked at one by one, many by way of a
/// tree, beside which stand those that are infinitely far. Every light keeps a part of the choice
/// that does not ask where the point is, since it may be the only one that nothing hides.
/// Immutable; called concurrently.
class LightPicker {
 public:
  /// More lights are not looked at one by one for each point.
  static constexpr size_t kFew = 128;

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
  Pick Choose(const Receiver& to, float u) const;
  /// That of a light to be chosen for a point.
  float Probability(const Receiver& to, uint32_t light) const;

  uint64_t MemoryBytes() const;

 private:
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

  void PlantTree();
  /// Whether a candidate is of the tree or far, and its place there.
  struct Part {
    bool is_far;
    uint32_t place;
  };
  /// The part of the choice that falls to the tree; the rest is that of far lights.
  float ShareOfTree(const Receiver& to) const;
  /// The choice of many that looks at the point: that of a part.
  float ChoiceOf(Part part, const Receiver& to) const;
  static float ProbabilityOfMany(const Candidate& candidate, float choice);
  Pick ChooseOfMany(const Receiver& to, double u) const;

  std::vector<Candidate> candidates_;
  std::vector<uint32_t> candidate_of_light_;  ///< kNever for those without power.
  bool looks_at_each_ = false;
  std::optional<AliasTable> table_;  ///< Of the shares.

  // Of many that are chosen by effect: those of the tree, the others, and by candidate which it is.
  std::optional<LightTree> tree_;
  std::vector<uint32_t> near_, far_;
  std::optional<AliasTable> far_table_;
  double far_effect_ = 0;
  std::vector<Part> parts_;  ///< Empty when there is no tree to be asked.
};

}  // namespace candela
