#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "lights/light.h"
#include "lights/light_cluster.h"

namespace candela {

/// Divides lights into two parts again and again, for `LightTree`. No part is deeper than 63,
/// however the lights lie.
class LightTreeBuilder {
 public:
  explicit LightTreeBuilder(std::span<const LightReach> lights);

  /// Lights that lie side by side in the order of the tree.
  struct Part {
    uint32_t begin, end;
    uint32_t depth;
    LightCluster cluster;

    uint32_t Count() const { return end - begin; }
  };
  Part Root() const;
  /// The two halves of a part of at least two lights.
  std::pair<Part, Part> Split(const Part& part);

  uint32_t LightAt(uint32_t place) const { return order_[place]; }

 private:
  /// Where a part is divided: across an axis, before a bin of centres.
  struct Plane {
    int axis = 0;
    int bin = 0;  ///< 0 when none was found.
  };
  struct Range {
    Vec3d min, max;
  };

  Range RangeOf(const Part& part) const;
  Plane BestPlane(const Part& part, const Range& range) const;
  Part PartOf(uint32_t begin, uint32_t end, uint32_t depth) const;

  std::vector<LightCluster> lights_;
  std::vector<Vec3d> centers_;
  std::vector<uint32_t> order_;
};

}  // namespace candela
