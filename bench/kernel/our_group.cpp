#include "our_group.h"

#include <utility>

namespace candela {
namespace {

GroupItem MeshItem(const TriangleMesh& mesh) {
  return {.content = TriangleInput{mesh.positions, mesh.triangles}};
}

Result<std::shared_ptr<const Group>> BuildGroup(GroupInput input, BuildQuality quality, int width) {
  BuildOptions options;
  options.quality = quality;
  options.width = width;
  Result<std::unique_ptr<Group>> group = Group::Build(std::move(input), options);
  if (!group) return group.error();
  return std::shared_ptr<const Group>(std::move(*group));
}

}  // namespace

Result<OurGroup> OurGroup::Build(const BenchScene& scene, BuildQuality quality, int width) {
  OurGroup ours;
  GroupInput input = {MeshItem(scene.mesh)};
  if (!scene.instances.empty()) {
    auto part = BuildGroup({MeshItem(scene.part)}, quality, width);
    if (!part) return part.error();
    ours.part_ = *part;
    for (const Mat4& world_from_part : scene.instances) {
      input.push_back({.content = InstanceInput{ours.part_, {world_from_part}}});
    }
  }
  auto group = BuildGroup(std::move(input), quality, width);
  if (!group) return group.error();
  ours.group_ = *group;
  return ours;
}

uint64_t OurGroup::MemoryBytes() const {
  return group_->MemoryBytes() + (part_ ? part_->MemoryBytes() : 0);
}

void OurGroup::Intersect(std::span<const Ray> rays, std::span<HitRecord> hits) const {
  for (size_t i = 0; i < rays.size(); ++i) group_->Intersect(rays[i], &hits[i]);
}

void OurGroup::Occluded(std::span<const Ray> rays, std::span<uint8_t> occluded) const {
  for (size_t i = 0; i < rays.size(); ++i) occluded[i] = group_->Occluded(rays[i]);
}

}  // namespace candela
