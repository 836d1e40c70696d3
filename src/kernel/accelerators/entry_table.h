#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/cancel_token.h"
#include "geometry/bounds3.h"
#include "kernel/build/build_items.h"
#include "math/transform.h"
#include "math/vec.h"

namespace candela::kernel {

/// One thing that may be hit: a primitive of an item.
struct Entry {
  uint32_t item, primitive;
};

/// What a group holds, in the plain form that grid, octree and brute force sort and test.
struct EntryTable {
  /// A copy, since the positions that a group is built of need not outlive that.
  struct Mesh {
    std::vector<Vec3> positions;  ///< At each time step, step after step.
    std::vector<std::array<uint32_t, 3>> triangles;
    uint32_t steps = 1;
  };

  std::vector<Entry> entries;               ///< Those with a box,
  std::vector<Entry> unbounded;             ///< and those without.
  std::vector<Mesh> meshes;                 ///< By item; empty for one of another kind.
  std::vector<Transform> group_from_world;  ///< By item, for instances: at time 0.

  uint64_t MemoryBytes() const;
};

/// Copies what can be hit; `boxes` gets a box for each of `entries`, the one that the kernel's tree
/// is built of, of moving things around all their times. Throws when cancelled.
EntryTable MakeEntryTable(std::span<const BuildItem> items, const CancelToken* cancel,
                          std::vector<Bounds3>* boxes);

}  // namespace candela::kernel
