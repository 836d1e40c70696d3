#pragma once

#include <cstdint>
#include <limits>

namespace candela {

/// The nearest hit found so far. A fresh record, as far away as can be, is not a hit.
struct HitRecord {
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  /// How deep groups may be instanced in groups, below the scene.
  static constexpr int kMostNested = 4;

  float t = std::numeric_limits<float>::max();
  float u = 0, v = 0;       ///< Position on the primitive; barycentric for triangles.
  uint32_t object = kNone;  ///< Index of the object in the scene.
  uint32_t primitive = 0;   ///< Index of the primitive (triangle) in the object's shape.
  /// Where the object is an instance of a group: the index of what was hit in that group, and so on
  /// inwards; kNone beyond.
  uint32_t nested[kMostNested] = {kNone, kNone, kNone, kNone};

  bool IsHit() const { return object != kNone; }
};

}  // namespace candela
