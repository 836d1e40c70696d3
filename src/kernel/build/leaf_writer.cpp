#include "kernel/build/leaf_writer.h"

#include <new>

#include "base/check.h"
#include "kernel/build/triangle_packer.h"

namespace candela::kernel {

void WriteLeaf(const BuildItem& item, std::span<const Fragment> fragments, uint32_t first_id,
               Record* record, uint32_t* triangle_ids) {
  if (item.instance) {
    WriteInstance(item, fragments[0].Item(), record);
  } else if (item.set) {
    auto& leaf = *new (record) PrimitiveLeaf{};
    for (const Fragment& fragment : fragments) {
      leaf.entry[leaf.count++] = {fragment.Item(), fragment.Primitive()};
    }
  } else {
    TrianglePacker packer(item);
    CHECK(packer.Pack(fragments));
    for (size_t i = 0; i < fragments.size(); ++i) {
      triangle_ids[first_id + i] = fragments[i].Primitive();
    }
    auto& leaf = *reinterpret_cast<TriangleLeaf*>(record);
    leaf.first = first_id;
    leaf.item = fragments[0].Item();
    packer.Write(&leaf);
  }
}

void WriteInstance(const BuildItem& item, uint32_t number, Record* record) {
  const auto inverse = InverseAffine(item.instance->world_from_group[0]);
  CHECK(inverse);
  auto& leaf = *new (record) InstanceLeaf{};
  leaf.group_from_world = Transform(*inverse);
  leaf.item = number;
}

}  // namespace candela::kernel
