#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "kernel/group.h"
#include "math/mat4.h"
#include "scene/object_primitive.h"
#include "scene/scene_object.h"

namespace candela {

/// What finds hits in a scene: one group of all objects, in which an object has the number that it
/// has in the scene.
struct SceneTree {
  std::vector<ObjectPrimitive> primitives;  ///< The group refers to them.
  std::vector<MovingObjectPrimitive> moving_primitives;
  /// Those of meshes that several objects have, in object space; the group holds instances of them.
  std::vector<std::shared_ptr<const Group>> mesh_groups;
  std::unique_ptr<const Group> group;
  /// A processor keeps all of it near itself. Then one ray after the other is quicker than many in
  /// flight, which have nothing to wait for.
  bool is_small = false;

  /// For each ray what the group answers; see there.
  void Intersect(RayOrder order, std::span<const Ray> rays, std::span<HitRecord> hits) const;
  void Occluded(RayOrder order, std::span<const Ray> rays, std::span<uint8_t> occluded) const;

  /// Of all groups.
  uint64_t MemoryBytes() const;
};

/// Builds the groups, all with the same accelerator. The matrices are those of the objects, in
/// double, for the instances among them that do not move. The objects have to stay where they are.
/// Fails with `kResources`.
Result<SceneTree> BuildSceneTree(std::span<const SceneObject> objects,
                                 std::span<const Mat4> world_from_object,
                                 AcceleratorKind accelerator);

}  // namespace candela
