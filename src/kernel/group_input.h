#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "geometry/ray.h"
#include "kernel/primitive_set.h"
#include "math/mat4.h"
#include "math/vec.h"

namespace candela {

class Group;

/// A triangle mesh. Triangles without area, and those with a corner that is not finite, are never
/// hit.
struct TriangleInput {
  /// The positions at each time step, step after step: steps * (number of vertices) of them. Needed
  /// while the group is built only.
  std::span<const Vec3> positions;
  std::span<const std::array<uint32_t, 3>> triangles;  ///< Indices below the number of vertices.
  uint32_t steps = 1;  ///< Evenly spread over times 0 to 1; positions are linear in between.
};

/// Primitives behind the two-function interface. The set has to outlive the group.
struct PrimitiveInput {
  const PrimitiveSet* set;
};

/// Another group in this one, with nodes of the same width (`BuildOptions::width`).
struct InstanceInput {
  std::shared_ptr<const Group> group;
  /// One matrix for each time step, affine, the first one invertible; linear, element by element,
  /// in between. Where one has no inverse, nothing of the group is there.
  std::vector<Mat4> world_from_group;
};

/// One thing in a group.
struct GroupItem {
  /// Nothing keeps the index free.
  std::variant<std::monostate, TriangleInput, PrimitiveInput, InstanceInput> content;
  uint32_t mask = kAnyRay;  ///< Kinds of rays that see it.
  /// Null: every hit counts. Has to outlive the group. Not for an instance, whose group's items
  /// have their own.
  const HitFilter* filter = nullptr;
};

/// What a group is made of. The index of an item is what a hit names.
using GroupInput = std::vector<GroupItem>;

}  // namespace candela
