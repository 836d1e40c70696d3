#include "kernel/build/triangle_packer.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace candela::kernel {
namespace {

/// Eight numbers that stay in registers: memory would make each search wait for the last addition.
class EightNumbers {
 public:
  /// Bit i: number i is equal.
  uint32_t EqualMask(uint32_t value) const {
    const Int4 all = Splat4(value);
    const Int4 bits = ((low_ == all) & Int4{1, 2, 4, 8}) | ((high_ == all) & Int4{16, 32, 64, 128});
    const Int4 pairs = bits | __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
    return static_cast<uint32_t>(pairs[0] | pairs[1]);
  }
  /// Nothing happens with a place of 8 or more.
  void Set(uint32_t place, uint32_t value) {
    const Int4 all = Splat4(value), at = Splat4(place);
    low_ = at == Int4{0, 1, 2, 3} ? all : low_;
    high_ = at == Int4{4, 5, 6, 7} ? all : high_;
  }
  void Store(uint32_t* to) const {
    std::memcpy(to, &low_, sizeof(low_));
    std::memcpy(to + 4, &high_, sizeof(high_));
  }

 private:
  static Int4 Splat4(uint32_t value) {
    const auto element = static_cast<int32_t>(value);
    return Int4{element, element, element, element};
  }

  Int4 low_ = {0, 0, 0, 0}, high_ = {0, 0, 0, 0};
};

}  // namespace

bool TrianglePacker::Pack(std::span<const Fragment> triangles) {
  if (triangles.size() > kMost) return false;
  triangles_ = static_cast<uint32_t>(triangles.size());
  // All at once, because each one is likely to wait for memory.
  uint32_t vertices[3 * kMost];
  for (uint32_t i = 0; i < triangles_; ++i) {
    std::memcpy(vertices + 3 * i, &item_.triangles->triangles[triangles[i].Primitive()],
                3 * sizeof(uint32_t));
  }
  return PackByIndex(vertices) || (item_.may_weld && PackByPosition(vertices));
}

bool TrianglePacker::PackByIndex(const uint32_t* vertices) {
  EightNumbers known;
  vertices_ = 0;
  for (uint32_t i = 0; i < 3 * triangles_; ++i) {
    const uint32_t found = known.EqualMask(vertices[i]) & ((1u << vertices_) - 1);
    known.Set(vertices_, vertices[i]);
    corner_[i] = found != 0 ? static_cast<uint32_t>(std::countr_zero(found)) : vertices_;
    vertices_ += found != 0 ? 0 : 1;
  }
  known.Store(vertex_);
  return vertices_ <= kMost;
}

/// Positions are compared as bits: 0 and -0 are different, whatever is done with them later.
bool TrianglePacker::PackByPosition(const uint32_t* vertices) {
  uint32_t position[3 * kMost][3];
  for (uint32_t i = 0; i < 3 * triangles_; ++i) {
    std::memcpy(position[i], &item_.triangles->positions[vertices[i]], sizeof(position[i]));
  }
  EightNumbers known[3], indices;
  vertices_ = 0;
  for (uint32_t i = 0; i < 3 * triangles_; ++i) {
    uint32_t found = (1u << vertices_) - 1;
    for (int axis = 0; axis < 3; ++axis) {
      found &= known[axis].EqualMask(position[i][axis]);
      known[axis].Set(vertices_, position[i][axis]);
    }
    indices.Set(vertices_, vertices[i]);
    corner_[i] = found != 0 ? static_cast<uint32_t>(std::countr_zero(found)) : vertices_;
    vertices_ += found != 0 ? 0 : 1;
    if (vertices_ > kMost) return false;
  }
  indices.Store(vertex_);
  return true;
}

void TrianglePacker::Write(TriangleLeaf* leaf) const {
  for (uint32_t corner = 0; corner < 3; ++corner) {
    uint32_t places = 0;
    for (uint32_t i = 0; i < triangles_; ++i) places |= corner_[3 * i + corner] << 3 * i;
    leaf->corner[corner] = places;
  }
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
