#include "kernel/build/leaf_writer.h"

#include <new>

#include "base/check.h"
#include "kernel/build/triangle_packer.h"

namespace candela::kernel {

void WriteLeaf(const BuildItem& item, std::span<const BinaryTree::Entry> entries, uint32_t first_id,
               Record* record, uint32_t* triangle_ids) {
  if (item.instance) {
    WriteInstance(item, entries[0].item, record);
  } else if (item.set) {
    auto& leaf = *new (record) PrimitiveLeaf{};
    for (const BinaryTree::Entry& entry : entries) {
      leaf.entry[leaf.count++] = {entry.item, entry.primitive};
    }
  } else {
    TrianglePacker packer(item);
    for (const BinaryTree::Entry& entry : entries) {
      CHECK(packer.Add(entry.primitive));
      triangle_ids[first_id + (&entry - entries.data())] = entry.primitive;
    }
    auto& leaf = *reinterpret_cast<TriangleLeaf*>(record);
    leaf.first = first_id;
    leaf.item = entries[0].item;
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
