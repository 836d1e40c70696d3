#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lights/light.h"
#include "lights/light_cluster.h"
#include "lights/receiver.h"
#include "math/vec.h"

namespace candela {

/// Chooses one of many lights of a scene for a point, in about the logarithm of their number of
/// steps: a binary tree over what is near to each other and shines the same way, down which one
/// goes by what each half may give to the point. A. Conty Estevez and C. Kulla, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting", 2018; without the splitting. Immutable;
/// called concurrently.
class LightTree {
 public:
  /// There are lights, fewer than 2^30, none of them far and each with power.
  explicit LightTree(std::span<const LightReach> lights);

  struct Pick {
    uint32_t light;
    float probability;  ///< Above 0.
  };
  /// `u` is in [0, 1).
  Pick Choose(const Receiver& to, double u) const;
  /// That of a light to be chosen for a point, the same bits; 0 for those that do not shine there.
  float Probability(const Receiver& to, uint32_t light) const;

  /// Roughly the irradiance that all lights together give to a point.
  float Effect(const Receiver& to) const { return Effect(nodes_[0], to); }

  uint64_t MemoryBytes() const {
    return nodes_.capacity() * sizeof(Node) + trails_.capacity() * sizeof(uint64_t);
  }

 private:
  /// A cluster in a form that is quick to look at.
  struct Node {
    Vec3 center;
    float radius;  ///< Of a ball around all of it.
    Vec3 axis;     ///< 0 when it shines all around.
    float power;
    float cos_spread, sin_spread;
    float cos_cone;
    uint32_t next : 31;  ///< The light, or the first of two halves, which lie side by side.
    uint32_t is_leaf : 1;
    bool is_flat, is_two_sided;
  };

  static Node NodeOf(const LightCluster& cluster);
  static float Effect(const Node& node, const Receiver& to);
  /// The part of the choice that falls to the first half of a node.
  float FirstShare(const Node& node, const Receiver& to) const;

  std::vector<Node> nodes_;       ///< The root comes first.
  std::vector<uint64_t> trails_;  ///< By light: from the root on, bits of the second halves.
};

}  // namespace candela
