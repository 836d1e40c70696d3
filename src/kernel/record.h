#pragma once

#include <cstddef>
#include <cstdint>

#include "math/transform.h"

/// The layout of a tree in memory: records of 128 bytes, two cache lines, in one arena, referred to
/// by their number. See docs/kernel.md for a picture.
namespace candela::kernel {

struct alignas(128) Record {
  std::byte bytes[128];
};

/// What a reference leads to. The hot loop knows nodes; everything else is looked at outside of it.
enum class RecordKind : uint32_t {
  kNode = 0,              ///< WideNode<W>; 0, so that the reference is the record's number.
  kTriangles = 1,         ///< TriangleLeaf, at rest, visible to all rays, without a filter.
  kCheckedTriangles = 2,  ///< TriangleLeaf of an item with a mask, a filter or time steps.
  kPrimitives = 3,        ///< PrimitiveLeaf
  kInstance = 4,          ///< InstanceLeaf
  kMovingNode = 5,        ///< MovingNode<W>: boxes at times 0 and 1.
  kLeaveInstance = 6,     ///< Never in the arena: a mark on the stack.
};

/// A reference: the kind in the upper three bits, the number of the (first) record in the others.
using Reference = uint32_t;
constexpr uint32_t kKindShift = 29;
constexpr uint32_t kMostRecords = 1u << kKindShift;
constexpr uint32_t kRecordMask = kMostRecords - 1;

constexpr Reference MakeReference(RecordKind kind, uint32_t record) {
  return static_cast<uint32_t>(kind) << kKindShift | record;
}
constexpr RecordKind KindOf(Reference reference) {
  return static_cast<RecordKind>(reference >> kKindShift);
}
constexpr uint32_t RecordOf(Reference reference) {
  return reference & kRecordMask;
}
constexpr bool IsNode(Reference reference) {
  return reference < kMostRecords;
}

/// The rows of a node's boxes. A ray reads near and far planes from the row that its direction
/// says, so that the loop has no sign to test.
enum BoxRow { kMinX, kMaxX, kMinY, kMaxY, kMinZ, kMaxZ, kBoxRows };

/// Up to W children: their boxes, row by row, and where they are. Children that are not there come
/// last; their boxes are empty (from plus to minus infinity), which no ray meets.
template <int W>
struct alignas(128) WideNode {
  float box[kBoxRows][W];
  Reference child[W];
};
static_assert(sizeof(WideNode<8>) == 256 && sizeof(WideNode<16>) == 512);

/// The same for what moves: a box at time 0 and one at time 1. In between a child stays within the
/// box that lies linearly between them.
template <int W>
struct alignas(128) MovingNode {
  float box[2][kBoxRows][W];
  Reference child[W];
};

/// Up to 8 triangles of one item that share up to 8 vertices; the rows of vertices are read like
/// registers. Of an item with time steps, the vertices of further steps follow: 96 bytes each, from
/// the next record on.
struct alignas(128) TriangleLeaf {
  /// Corner c of triangle i is vertex `corner[c] >> 3 * i & 7`.
  uint32_t corner[3];
  uint32_t lanes;  ///< Bit i: there is a triangle i.
  uint32_t first;  ///< Triangle i has the index `triangle_ids[first + i]` in its item.
  uint32_t item;
  uint32_t steps;
  uint32_t unused;
  float vertex[3][8];  ///< x, y and z; those that are not used are copies of the first.

  uint32_t Corner(int corner_number, int lane) const {
    return corner[corner_number] >> 3 * lane & 7;
  }
};
static_assert(sizeof(TriangleLeaf) == 128);

/// Where the vertices of the first time step are in a `TriangleLeaf`.
constexpr size_t kVertexOffset = offsetof(TriangleLeaf, vertex);

/// Records of a triangle leaf with so many time steps.
constexpr uint32_t TriangleLeafRecords(uint32_t steps) {
  return (32 + 96 * steps + 127) / 128;
}

/// Primitives of sets.
struct alignas(128) PrimitiveLeaf {
  static constexpr uint32_t kMost = 15;

  uint32_t count;
  uint32_t unused;
  struct {
    uint32_t item, primitive;
  } entry[kMost];
};
static_assert(sizeof(PrimitiveLeaf) == 128);

/// An instance at rest is entered with what stands here; for a moving one the group interpolates.
struct alignas(128) InstanceLeaf {
  Transform group_from_world;
  uint32_t item;
};
static_assert(sizeof(InstanceLeaf) == 128);

}  // namespace candela::kernel
