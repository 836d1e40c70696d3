#pragma once

#include <cstddef>
#include <cstdint>

#include "kernel/build/build_items.h"
#include "kernel/record.h"

namespace candela::kernel {

/// Packs up to 8 triangles of one item with up to 8 different vertices into a `TriangleLeaf`.
///
/// Vertices with different indices and the same position become one, so that triangles without
/// shared vertices are packed as well as others. Not those of moving items: their vertices may
/// meet at one time step only.
class TrianglePacker {
 public:
  static constexpr uint32_t kMost = 8;

  explicit TrianglePacker(const BuildItem& item) : item_(item) {}

  /// Adds a triangle unless it does not fit; then the packer is of no further use.
  bool Add(uint32_t triangle);

  /// Writes corners, lanes, steps and vertices, of all time steps.
  void Write(TriangleLeaf* leaf) const;

 private:
  /// The place of a vertex, which is added when it is new; kMost when there is no room.
  uint32_t Find(uint32_t vertex);

  const BuildItem& item_;
  uint32_t triangles_ = 0;
  uint32_t vertices_ = 0;
  uint32_t corner_[3] = {0, 0, 0};
  uint32_t vertex_[kMost];
  Vec3 position_[kMost];
};

/// Vertex v of a time step of a leaf: `row[axis][v]`.
using VertexRows = float[3][8];
inline VertexRows& RowsOfStep(TriangleLeaf* leaf, uint32_t step) {
  // The rows of further steps stand behind those of the first, up to the last record of the leaf.
  return *reinterpret_cast<VertexRows*>(reinterpret_cast<std::byte*>(leaf) +
                                        offsetof(TriangleLeaf, vertex) + step * sizeof(VertexRows));
}

}  // namespace candela::kernel
