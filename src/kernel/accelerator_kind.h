#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace candela {

/// What finds the hits of a group. All kinds find the same ones, bit for bit, for rays that start
/// within a few hundred times the width of the group. From farther away rounding lets the tree pass
/// by the edges of boxes that are no wider than what is in them, as those of turned rectangles are.
enum class AcceleratorKind : uint8_t {
  kBvh,     ///< The kernel's own: a wide bounding volume hierarchy.
  kGrid,    ///< For courses and comparison: a uniform grid,
  kOctree,  ///< an octree,
  kNone,    ///< and no structure at all.
};

/// A row of the table of accelerators.
struct AcceleratorEntry {
  AcceleratorKind kind;
  std::string_view name;
  std::string_view description;
};

/// All of them, in the order of the manual.
std::span<const AcceleratorEntry> Accelerators();

/// The row of that name, or null.
const AcceleratorEntry* FindAccelerator(std::string_view name);

std::string_view AcceleratorName(AcceleratorKind kind);

}  // namespace candela
