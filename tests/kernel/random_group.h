#pragma once

#include <string>
#include <vector>

#include "tests/kernel/group_description.h"

namespace candela::test {

/// What a random group is mostly made of.
enum class GroupKind {
  kSoup,       ///< Triangles without neighbours.
  kMeshes,     ///< Closed and open surfaces; some of them twice, so that hits tie.
  kMixed,      ///< Big and tiny triangles and slivers, in one mesh.
  kBoxes,      ///< Axis-aligned, in a lattice.
  kSpheres,    ///< Primitives of sets, with an unbounded one, beside some triangles.
  kInstances,  ///< Groups in groups, up to four levels, under any affine maps.
  kMoving,     ///< Triangles, spheres and instances with 2 to 4 time steps.
  kEverything,
};
inline constexpr int kGroupKinds = 8;

/// Items have masks and filters now and then. The same group for the same numbers.
GroupDescription RandomGroup(GroupKind kind, UniformNumbers* random);

/// Rays through about the cube from -2 to 2: aimed at points near vertices, along axes through
/// vertices, anywhere; at several times, with masks and limits; and bundles of 16 from one point.
std::vector<Ray> RandomRays(const GroupDescription& group, size_t count, UniformNumbers* random);

}  // namespace candela::test
