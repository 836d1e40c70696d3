#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/build/build_items.h"
#include "kernel/build/fragment.h"
#include "kernel/record.h"

namespace candela::kernel {

/// Packs up to 8 triangles of one item with up to 8 different vertices into a `TriangleLeaf`.
///
/// Where a mesh shares few vertices and there are too many indices, vertices with the same position
/// become one, so that such triangles are packed as well as others.
class TrianglePacker {
 public:
  static constexpr uint32_t kMost = 8;

  explicit TrianglePacker(const BuildItem& item) : item_(item) {}

  /// Whether the triangles, which are of the item, fit into one leaf.
  bool Pack(std::span<const Fragment> triangles);

  /// Writes corners, lanes, steps and vertices, of all time steps.
  void Write(TriangleLeaf* leaf) const;

 private:
  bool PackByIndex(const uint32_t* vertices);
  bool PackByPosition(const uint32_t* vertices);

  const BuildItem& item_;
  uint32_t triangles_ = 0;
  uint32_t vertices_ = 0;       ///< Different ones.
  uint32_t vertex_[kMost];      ///< Their indices.
  uint32_t corner_[3 * kMost];  ///< The place in `vertex_` of corner c of triangle i at 3 i + c.
};

/// Vertex v of a time step of a leaf: `row[axis][v]`.
using VertexRows = float[3][8];
inline VertexRows& RowsOfStep(TriangleLeaf* leaf, uint32_t step) {
  // The rows of further steps stand behind those of the first, up to the last record of the leaf.
  return *reinterpret_cast<VertexRows*>(reinterpret_cast<std::byte*>(leaf) +
                                        offsetof(TriangleLeaf, vertex) + step * sizeof(VertexRows));
}

}  // namespace candela::kernel
