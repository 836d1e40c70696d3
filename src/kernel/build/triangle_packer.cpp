#include "kernel/build/triangle_packer.h"

#include <bit>
#include <cstring>

namespace candela::kernel {
namespace {

/// As bits: 0 and -0 are different, whatever is done with them later.
bool IsSame(Vec3 a, Vec3 b) {
  return std::memcmp(&a, &b, sizeof(Vec3)) == 0;
}

}  // namespace

uint32_t TrianglePacker::Find(uint32_t vertex) {
  for (uint32_t i = 0; i < vertices_; ++i) {
    if (vertex_[i] == vertex) return i;
  }
  const Vec3 position = item_.Position(0, vertex);
  if (!item_.IsMoving()) {
    for (uint32_t i = 0; i < vertices_; ++i) {
      if (IsSame(position_[i], position)) return i;
    }
  }
  if (vertices_ == kMost) return kMost;
  vertex_[vertices_] = vertex;
  position_[vertices_] = position;
  return vertices_++;
}

bool TrianglePacker::Add(uint32_t triangle) {
  if (triangles_ == kMost) return false;
  for (int corner = 0; corner < 3; ++corner) {
    const uint32_t place = Find(item_.triangles->triangles[triangle][static_cast<size_t>(corner)]);
    if (place == kMost) return false;
    corner_[corner] |= place << 3 * triangles_;
  }
  ++triangles_;
  return true;
}

void TrianglePacker::Write(TriangleLeaf* leaf) const {
  for (int corner = 0; corner < 3; ++corner) leaf->corner[corner] = corner_[corner];
  leaf->lanes = (1u << triangles_) - 1;
  leaf->steps = item_.steps;
  leaf->unused = 0;
  for (uint32_t step = 0; step < item_.steps; ++step) {
    VertexRows& rows = RowsOfStep(leaf, step);
    for (uint32_t i = 0; i < kMost; ++i) {
      const Vec3 position = item_.Position(step, vertex_[i < vertices_ ? i : 0]);
      for (int axis = 0; axis < 3; ++axis) rows[axis][i] = position[axis];
    }
  }
}

}  // namespace candela::kernel
