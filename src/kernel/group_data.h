#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/isa.h"
#include "geometry/bounds3.h"
#include "geometry/ray.h"
#include "kernel/accelerator_kind.h"
#include "kernel/arena.h"
#include "kernel/primitive_set.h"
#include "kernel/record.h"
#include "math/moving_transform.h"

namespace candela {
class Group;
}

namespace candela::kernel {

class Accelerator;
struct TraceFunctions;

/// What a search has to know of an item beyond the records.
struct ItemFacts {
  uint32_t count = 0;  ///< Its primitives.
  uint32_t mask = kAnyRay;
  const HitFilter* filter = nullptr;
  const PrimitiveSet* set = nullptr;
  std::shared_ptr<const Group> group;
  MovingInverse motion;  ///< Of an instance that moves; else without steps.
};

/// A built group: the tree and what its searches need. `BuildGroup` makes it.
struct GroupData {
  static constexpr Reference kNothing = 0xFFFFFFFF;

  Arena records;
  Reference root =
      kNothing;  ///< A node, or a leaf where there is only one; kNothing without items.
  /// The index, in its item, of each triangle of the leaves: see `TriangleLeaf::first`.
  std::vector<uint32_t> triangle_ids;
  std::vector<ItemFacts> items;
  /// Leaves of primitives and instances that have no box; they stand beside the tree.
  std::vector<Reference> unbounded;

  // What a search begins with, put together from the above:
  /// Leaves of primitives that need no tree to be found, since they are unbounded or the only ones.
  std::vector<Reference> first_primitives;
  /// What goes on its stack: the root, unless it is such a leaf, and unbounded instances.
  std::vector<Reference> entries;

  Bounds3 bounds;      ///< Of everything in the tree, at all times.
  int width = 8;       ///< Children of a node: WideNode<width>.
  int depth = 0;       ///< Nodes on the longest way down from the root.
  int levels = 1;      ///< Of groups in groups, this one included.
  bool moves = false;  ///< Whether an item has time steps, here or in a group inside.
  /// Entries that a search may have to keep at once, those that it begins with and groups inside
  /// included.
  uint32_t stack_need = 0;
  float largest_coordinate = 0;  ///< Of `bounds`, by magnitude.

  /// What finds hits in the place of the records; null for `kBvh`.
  std::shared_ptr<const Accelerator> structure;
  AcceleratorKind accelerator = AcceleratorKind::kBvh;

  Isa isa = Isa::kScalar;
  const TraceFunctions* trace = nullptr;
};

/// Groups in groups below the outermost one, and entries on the stack of a search, at most. The
/// builder keeps within them.
constexpr int kMostLevels = 1 + HitRecord::kMostNested;
constexpr uint32_t kMostTreeStack = 200;  ///< Of one tree.
constexpr uint32_t kMostSearchStack = kMostLevels * (kMostTreeStack + 3);
/// With room for those that are written beyond the last one.
constexpr uint32_t kMostStack = kMostSearchStack + 16;

}  // namespace candela::kernel
