#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace candela {

/// Twice the signed area of a triangle of the plane: positive when a, b, c turn counter-clockwise.
/// For coordinates of similar size the differences and products are exact, and so is the sign.
double Orient(Vec2 a, Vec2 b, Vec2 c);

/// Points of a plane, arranged so that few of them need a look to tell whether a triangle holds
/// one: a balanced k-d tree [Bentley 1975] with the box of each subtree.
class PointTree {
 public:
  /// Starts anew with `members`, numbers of points in `points`, which must stay where they are.
  void Build(std::span<const Vec2> points, std::span<const uint32_t> members);

  /// Takes a point out; one that is not (or no longer) in the tree changes nothing.
  void Remove(uint32_t point);

  /// True when a point of the tree lies in the counter-clockwise triangle or on its edges. Points
  /// at the very place of a corner do not count.
  bool HasPointIn(Vec2 a, Vec2 b, Vec2 c) const;

 private:
  struct Node {
    Vec2 low, high;
    uint32_t begin, end;  ///< Of `order_`.
    uint32_t left;        ///< The number of points that were not removed.
    uint32_t second;      ///< The second child; the first one is the next node. 0 in leaves.
  };
  struct Triangle {
    Vec2 a, b, c, low, high;
  };

  uint32_t BuildNode(uint32_t begin, uint32_t end);
  bool Search(const Triangle& triangle, uint32_t node) const;

  std::span<const Vec2> points_;
  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;  ///< Members, those of each node side by side.
  std::vector<uint32_t> slots_;  ///< Of each point: where it stands in `order_`, or kGone.
};

}  // namespace candela
