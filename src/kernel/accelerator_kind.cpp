#include "kernel/accelerator_kind.h"

#include <algorithm>
#include <iterator>

namespace candela {
namespace {

constexpr AcceleratorEntry kAccelerators[] = {
    {AcceleratorKind::kBvh, "bvh", "a wide bounding volume hierarchy, by far the fastest"},
    {AcceleratorKind::kGrid, "grid", "a uniform grid, walked cell by cell"},
    {AcceleratorKind::kOctree, "octree", "cells that are cut into eight where much is"},
    {AcceleratorKind::kNone, "none", "every ray is tested against everything"},
};

}  // namespace

std::span<const AcceleratorEntry> Accelerators() {
  return kAccelerators;
}

const AcceleratorEntry* FindAccelerator(std::string_view name) {
  const auto found = std::ranges::find(kAccelerators, name, &AcceleratorEntry::name);
  return found == std::end(kAccelerators) ? nullptr : found;
}

std::string_view AcceleratorName(AcceleratorKind kind) {
  return std::ranges::find(kAccelerators, kind, &AcceleratorEntry::kind)->name;
}

}  // namespace candela
