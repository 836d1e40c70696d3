#pragma once

#include <functional>
#include <vector>

#include "tests/kernel/group_description.h"

namespace candela::test {

/// A scene of the table.
struct DegenerateScene {
  const char* name;
  std::function<GroupDescription()> make;
  /// Coordinates beyond 1e37: differences of them and distances may not be floats, and hits may be
  /// lost. What is found is finite all the same.
  bool is_too_large = false;
  /// Rays in the plane of the triangles: the distance that rounding leaves there may lie before the
  /// box of the piece of a split triangle that is met; the hit then counts at the entry of the box.
  bool has_rays_in_plane = false;
};

// Geometry that nobody means to make.

/// Meshes: nothing, a million times the same, without area, flat, huge, tiny, not a number.
std::vector<DegenerateScene> DegenerateMeshes();
/// Instances, motion, and primitives of sets.
std::vector<DegenerateScene> DegenerateGroups();
/// All of them.
const std::vector<DegenerateScene>& DegenerateScenes();

/// A group of instances of another; for each of them its matrices at the time steps.
GroupDescription InstancesOf(GroupDescription inner, const std::vector<std::vector<Mat4>>& steps);

}  // namespace candela::test
