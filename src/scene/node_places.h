#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "math/mat4.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Where a node is in the world.
struct NodePlace {
  Mat4 begin;                ///< At time 0.
  std::vector<Mat4> motion;  ///< As in `NodeSpec`; empty when it does not move.

  bool IsMoving() const { return !motion.empty(); }
};

/// Those of all nodes. The places of nodes within moving ones are products at common moments, the
/// fewest that contain all of both; it is reported when these are too many, for one node or
/// together.
std::vector<NodePlace> PlacesOfNodes(const SceneSpec& spec, Diagnostics* diagnostics);

}  // namespace candela
