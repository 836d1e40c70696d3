#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "kernel/build/box4.h"
#include "kernel/group_input.h"
#include "kernel/record.h"

namespace candela::kernel {

struct GroupData;

/// An item of the input in the form that the builder asks for.
struct BuildItem {
  const TriangleInput* triangles = nullptr;  ///< One of these three, or none of them.
  const PrimitiveSet* set = nullptr;
  const InstanceInput* instance = nullptr;

  RecordKind leaf = RecordKind::kTriangles;
  uint32_t count = 0;  ///< Of primitives.
  uint32_t steps = 1;
  size_t vertex_count = 0;  ///< Of triangles, at one time step.
  /// Whether vertices of the same position may become one. Worth it where triangles share few; not
  /// of moving ones, which may meet at one time step only.
  bool may_weld = false;

  /// Whether a spatial split may cut it. A piece is tested where another piece is hit, too, at the
  /// entry of its own box at least; a filter would be asked about hits that are not there.
  bool may_split = false;

  bool IsMoving() const { return steps > 1; }

  Vec3 Position(uint32_t step, uint32_t vertex) const {
    return triangles->positions[step * vertex_count + vertex];
  }
};

std::vector<BuildItem> MakeBuildItems(const GroupInput& input);

/// Fails for an instance that a group with such nodes and such an accelerator cannot have.
Result<void> CheckInstance(const GroupItem& item, const InstanceInput& instance,
                           const GroupData& group);

/// What `BoxOf` finds instead of a box.
enum class BoxState {
  kBox,
  kNothing,    ///< It is never hit.
  kUnbounded,  ///< It has no finite box.
};

/// The padded box of a triangle at rest.
///
/// Hits are computed from sheared coordinates (Woop, Benthin, Wald: Watertight Ray/Triangle
/// Intersection, 2013) and may lie beside the triangle by a rounding error, in proportion to its
/// size. The padding makes sure that they lie in the box, so that a ray which meets the triangle by
/// that computation meets the boxes above it, too.
BoxState BoxOfTriangle(const BuildItem& item, uint32_t triangle, Box4* box);

/// The box of a primitive of any item at rest.
BoxState BoxOf(const BuildItem& item, uint32_t primitive, Box4* box);

/// Boxes of a primitive of a moving item: in between it stays within the box that lies linearly
/// between them.
BoxState LinearBoxOf(const BuildItem& item, uint32_t primitive, LinearBox* box);

/// Widens a box on all sides by a length, and rounds outwards. The result is finite.
Box4 Padded(const Box4& box, float padding);

/// How much the box of a triangle is widened, in proportion to its largest extent: 4e-7, and the
/// rounding of this product and of the extent.
constexpr float kTrianglePadding = 4.00001e-7f;

}  // namespace candela::kernel
