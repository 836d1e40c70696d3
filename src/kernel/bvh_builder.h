#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/bvh.h"

namespace candela {

/// Builds a `Bvh`. One use per object.
class BvhBuilder {
 public:
  BvhBuilder(std::span<const Bounds3> boxes, Bvh* bvh);
  void Build();

 private:
  struct Reference {
    Bounds3 bounds;
    Vec3 center;
    uint32_t item;
  };
  struct Range {
    uint32_t node, begin, end;
    int depth;
  };
  struct Split {
    int axis = 0;
    int bin = 0;  ///< Bins below it go left.
    double cost = Bounds3::kInfinity;
  };

  void Place(const Range& range, std::vector<Range>* todo);
  Split FindSplit(std::span<const Reference> references, const Bounds3& centers) const;
  uint32_t Partition(const Range& range, const Bounds3& bounds, const Bounds3& centers);

  std::vector<Reference> references_;
  Bvh& bvh_;
};

}  // namespace candela
