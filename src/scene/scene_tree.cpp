#include "scene/scene_tree.h"

#include <map>
#include <optional>
#include <utility>

namespace candela {
namespace {

/// Measured where the two ways to trace lists cross, with meshes of 1000 to 130,000 triangles.
constexpr uint64_t kMostBytesOfSmall = 100'000;

class SceneTreeBuilder {
 public:
  SceneTreeBuilder(std::span<const SceneObject> objects, std::span<const Mat4> world_from_object,
                   AcceleratorKind accelerator)
      : objects_(objects), world_from_object_(world_from_object) {
    options_.accelerator = accelerator;
  }

  Result<SceneTree> Build() {
    GroupInput input(objects_.size());
    // The group keeps their addresses.
    tree_.primitives.reserve(objects_.size());
    tree_.moving_primitives.reserve(objects_.size());
    for (size_t i = 0; i < objects_.size(); ++i) {
      const auto triangles = objects_[i].shape->Triangles();
      if (!triangles && objects_[i].is_moving) {
        tree_.moving_primitives.emplace_back(objects_[i]);
        input[i].content = PrimitiveInput{&tree_.moving_primitives.back()};
      } else if (!triangles) {
        tree_.primitives.emplace_back(objects_[i]);
        input[i].content = PrimitiveInput{&tree_.primitives.back()};
      } else if (!objects_[i].is_instance) {
        input[i].content = *triangles;
      } else {
        auto group = GroupOf(objects_[i].shape.get(), *triangles);
        if (!group) return group.error();
        std::vector<Mat4> steps = {world_from_object_[i]};
        if (objects_[i].is_moving) steps = objects_[i].space->steps();
        input[i].content = InstanceInput{*std::move(group), std::move(steps)};
      }
      if (objects_[i].has_holes) input[i].mask = kAnyRay & ~uint32_t{kShadowRay};
    }
    auto group = Group::Build(std::move(input), options_);
    if (!group) return group.error();
    tree_.group = *std::move(group);
    tree_.is_small = tree_.MemoryBytes() <= kMostBytesOfSmall;
    return std::move(tree_);
  }

 private:
  /// The group of a mesh in object space, built when it is asked for the first time.
  Result<std::shared_ptr<const Group>> GroupOf(const Shape* shape, const TriangleInput& triangles) {
    std::shared_ptr<const Group>& group = groups_[shape];
    if (group) return group;
    auto built = Group::Build({GroupItem{triangles}}, options_);
    if (!built) return built.error();
    group = *std::move(built);
    tree_.mesh_groups.push_back(group);
    return group;
  }

  const std::span<const SceneObject> objects_;
  const std::span<const Mat4> world_from_object_;
  BuildOptions options_;
  std::map<const Shape*, std::shared_ptr<const Group>> groups_;
  SceneTree tree_;
};

}  // namespace

void SceneTree::Intersect(RayOrder order, std::span<const Ray> rays,
                          std::span<HitRecord> hits) const {
  if (order == RayOrder::kScattered && is_small) {
    for (size_t i = 0; i < rays.size(); ++i) group->Intersect(rays[i], &hits[i]);
  } else {
    group->Intersect(order, rays, hits);
  }
}

void SceneTree::Occluded(RayOrder order, std::span<const Ray> rays,
                         std::span<uint8_t> occluded) const {
  if (order == RayOrder::kScattered && is_small) {
    for (size_t i = 0; i < rays.size(); ++i) occluded[i] = group->Occluded(rays[i]);
  } else {
    group->Occluded(order, rays, occluded);
  }
}

uint64_t SceneTree::MemoryBytes() const {
  uint64_t bytes = group->MemoryBytes() + primitives.capacity() * sizeof(ObjectPrimitive) +
                   moving_primitives.capacity() * sizeof(MovingObjectPrimitive);
  for (const auto& mesh : mesh_groups) bytes += mesh->MemoryBytes();
  return bytes;
}

Result<SceneTree> BuildSceneTree(std::span<const SceneObject> objects,
                                 std::span<const Mat4> world_from_object,
                                 AcceleratorKind accelerator) {
  return SceneTreeBuilder(objects, world_from_object, accelerator).Build();
}

}  // namespace candela
