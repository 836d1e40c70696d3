#include "kernel/accelerators/entry_table.h"

#include "base/check.h"
#include "kernel/build/fragment.h"

namespace candela::kernel {
namespace {

BoxState BoxAtAllTimes(const BuildItem& item, uint32_t primitive, Bounds3* bounds) {
  Box4 box;
  BoxState state;
  if (item.IsMoving()) {
    LinearBox moving;
    state = LinearBoxOf(item, primitive, &moving);
    box = moving.at[0];
    box.Extend(moving.at[1]);
  } else {
    state = BoxOf(item, primitive, &box);
  }
  *bounds = box.ToBounds();
  return state;
}

}  // namespace

uint64_t EntryTable::MemoryBytes() const {
  uint64_t bytes = (entries.capacity() + unbounded.capacity()) * sizeof(Entry) +
                   group_from_world.capacity() * sizeof(Transform) +
                   meshes.capacity() * sizeof(Mesh);
  for (const Mesh& mesh : meshes) {
    bytes += mesh.positions.capacity() * sizeof(Vec3) +
             mesh.triangles.capacity() * sizeof(mesh.triangles[0]);
  }
  return bytes;
}

EntryTable MakeEntryTable(std::span<const BuildItem> items, const CancelToken* cancel,
                          std::vector<Bounds3>* boxes) {
  EntryTable table;
  table.meshes.resize(items.size());
  table.group_from_world.resize(items.size());
  for (uint32_t i = 0; i < items.size(); ++i) {
    const BuildItem& item = items[i];
    if (item.triangles) {
      const TriangleInput& from = *item.triangles;
      table.meshes[i] = {{from.positions.begin(), from.positions.end()},
                         {from.triangles.begin(), from.triangles.end()},
                         item.steps};
    } else if (item.instance) {
      const auto inverse = InverseAffine(item.instance->world_from_group[0]);
      CHECK(inverse);
      table.group_from_world[i] = Transform(*inverse);
    }
    for (uint32_t primitive = 0; primitive < item.count; ++primitive) {
      if (primitive % 4096 == 0) StopWhenCancelled(cancel);
      Bounds3 box;
      const BoxState state = BoxAtAllTimes(item, primitive, &box);
      if (state == BoxState::kUnbounded) table.unbounded.push_back({i, primitive});
      if (state != BoxState::kBox) continue;
      table.entries.push_back({i, primitive});
      boxes->push_back(box);
    }
  }
  return table;
}

}  // namespace candela::kernel
