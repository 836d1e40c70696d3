#pragma once

#include <span>
#include <vector>

#include "geometry/bounds3.h"
#include "kernel/accelerators/accelerator.h"
#include "kernel/accelerators/precise_ray.h"

namespace candela::kernel {

/// A cube that is cut into eight, and each part again while much reaches into it: Glassner, "Space
/// Subdivision for Fast Ray Tracing", 1984. A ray looks at the parts that it meets, the nearest
/// first.
class Octree final : public Accelerator {
 public:
  Octree(EntryTable table, std::span<const Bounds3> boxes, const CancelToken* cancel);

  bool Walk(EntrySearch* search) const override;
  uint64_t MemoryBytes() const override;

  /// Cuts on the longest way down.
  int Depth() const { return depth_; }
  static constexpr int kMostDepth = 16;

  /// A cell: with the edges of a cube, but for rounding.
  struct Cube {
    Vec3d low, high;

    /// One of its eight parts: bit k of the number says on which side of axis k it lies.
    Cube Part(uint32_t part) const;
  };

 private:
  struct Node {
    uint32_t first;  ///< Of a leaf, where its list begins; else the first of eight children.
    uint32_t count;  ///< Of a leaf, how many entries it lists; else `kInner`.
  };
  static constexpr uint32_t kInner = 0xFFFFFFFF;

  class Builder;
  class Walker;

  std::vector<Node> nodes_;       ///< The root first.
  std::vector<uint32_t> listed_;  ///< Indices of entries, leaf after leaf.
  Cube cube_;
  int depth_ = 0;
};

}  // namespace candela::kernel
