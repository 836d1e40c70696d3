#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/bounds3.h"
#include "geometry/ray.h"

namespace candela {

/// A bounding volume hierarchy over boxes: a binary tree split by the binned surface area heuristic
/// (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007). Knows nothing of
/// what is in the boxes. Immutable once built; safe for concurrent use.
class Bvh {
 public:
  Bvh() = default;
  /// Builds over finite or empty boxes; an empty one is never visited. Items are named by their
  /// index.
  explicit Bvh(std::span<const Bounds3> boxes);

  /// Calls `visit(item)` for each item whose box the ray meets between `ray.t_min` and the current
  /// `*t_limit`, both included, which `visit` may lower; near subtrees come first. Stops when
  /// `visit` returns true. Boxes that the ray misses by no more than the rounding error of the test
  /// are visited too, so no hit inside a box is lost. `*t_limit` is finite.
  template <class Visit>
  void Traverse(const Ray& ray, const float* t_limit, Visit&& visit) const {
    TraversePlaces(ray, t_limit, [&](uint32_t place) { return visit(items_[place]); });
  }

  /// The same, but calls `visit(place)` with the item's place in `Items()`, for owners who keep
  /// their items in that order, so that those of a leaf lie side by side in memory.
  template <class Visit>
  void TraversePlaces(const Ray& ray, const float* t_limit, Visit&& visit) const;

  /// The items in the order of the leaves: place i of the tree holds `Items()[i]`.
  std::span<const uint32_t> Items() const { return items_; }

  /// The box around everything.
  Bounds3 Bounds() const { return nodes_.empty() ? Bounds3() : nodes_[0].bounds; }
  uint64_t MemoryBytes() const;
  /// Nodes on the longest path from the root to a leaf, at most `kMostDepth`.
  int Depth() const;

  /// No path from the root to a leaf is longer: the builder switches to halving in time.
  static constexpr int kMostDepth = 64;

 private:
  friend class BvhBuilder;

  struct Node {
    Bounds3 bounds;
    uint32_t first = 0;  ///< Inner: the left child, the right one follows it. Leaf: its first item.
    uint32_t count = 0;  ///< Items of a leaf; 0 for inner nodes.
  };

  /// What the box test needs of a ray, computed once.
  struct BoxRay {
    Vec3 origin, inverse_direction;
    float t_min;
    explicit BoxRay(const Ray& ray);
  };
  static float EntryOrMiss(const BoxRay& ray, const Bounds3& box, float t_limit);

  std::vector<Node> nodes_;
  std::vector<uint32_t> items_;
};

inline Bvh::BoxRay::BoxRay(const Ray& ray)
    : origin(ray.origin),
      inverse_direction{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
      t_min(ray.t_min) {}

/// The ray's entry into the box, or infinity when it misses it before `t_limit`. The comparisons
/// are written so that a NaN, from 0 * infinity when the origin lies on a slab that the ray is
/// parallel to, does not shrink the interval. After Ize, "Robust BVH Ray Traversal", 2013, but both
/// ends make up for the three roundings of a distance, and for those of a hit at t_min or t_limit,
/// which is computed in another way.
inline float Bvh::EntryOrMiss(const BoxRay& ray, const Bounds3& box, float t_limit) {
  constexpr float kRounding = 6e-7f;
  float entry = ray.t_min;
  float exit = t_limit;
  for (int axis = 0; axis < 3; ++axis) {
    const float to_min = (box.min[axis] - ray.origin[axis]) * ray.inverse_direction[axis];
    const float to_max = (box.max[axis] - ray.origin[axis]) * ray.inverse_direction[axis];
    const float near = ray.inverse_direction[axis] < 0 ? to_max : to_min;
    const float far = ray.inverse_direction[axis] < 0 ? to_min : to_max;
    entry = near > entry ? near : entry;
    exit = far < exit ? far : exit;
  }
  entry *= 1 - kRounding;
  return entry <= exit * (1 + kRounding) ? entry : Bounds3::kInfinity;
}

template <class Visit>
void Bvh::TraversePlaces(const Ray& ray, const float* t_limit, Visit&& visit) const {
  if (nodes_.empty()) return;
  const BoxRay box_ray(ray);
  struct Entry {
    uint32_t node;
    float t;
  };
  Entry stack[kMostDepth + 1];
  int size = 0;
  Entry current{0, EntryOrMiss(box_ray, nodes_[0].bounds, *t_limit)};
  while (true) {
    // A box entered exactly at the limit is still visited: an equal hit may win by its index.
    if (current.t <= *t_limit) {
      const Node& node = nodes_[current.node];
      if (node.count == 0) {
        Entry near{node.first, EntryOrMiss(box_ray, nodes_[node.first].bounds, *t_limit)};
        Entry far{node.first + 1, EntryOrMiss(box_ray, nodes_[node.first + 1].bounds, *t_limit)};
        if (far.t < near.t) std::swap(near, far);
        if (far.t <= *t_limit) stack[size++] = far;
        current = near;
        continue;
      }
      for (uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (visit(i)) return;
      }
    }
    if (size == 0) return;
    current = stack[--size];
  }
}

}  // namespace candela
