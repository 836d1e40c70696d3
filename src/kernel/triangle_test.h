#pragma once

#include <bit>

#include "geometry/triangle.h"
#include "kernel/search.h"

namespace candela::kernel {

/// Rows of x, y and z of the vertices of a leaf.
using LeafVertices = const float (*)[8];

/// The sheared coordinates of a leaf's vertices, and with them the edge areas of all its triangles:
/// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013. Vertices that triangles
/// share are sheared once; nothing is fused, so that an area changes its sign and nothing else
/// when an edge is walked in the other direction. Returns the triangles that may be hit.
template <class L>
[[gnu::always_inline]] inline uint32_t TestEdges(const ShearedRay& ray, const TriangleLeaf& leaf,
                                                 const float (*vertex)[8], float (*areas)[8]) {
  using F = typename L::Leaf;
  const F to_z = F::Load(vertex[ray.kz]) - F::Broadcast(ray.origin_z);
  const F x =
      (F::Load(vertex[ray.kx]) - F::Broadcast(ray.origin_x)) + to_z * F::Broadcast(ray.shear_x);
  const F y =
      (F::Load(vertex[ray.ky]) - F::Broadcast(ray.origin_y)) + to_z * F::Broadcast(ray.shear_y);

  const auto corner_a = L::Index::Unpack(leaf.corner[0]);
  const auto corner_b = L::Index::Unpack(leaf.corner[1]);
  const auto corner_c = L::Index::Unpack(leaf.corner[2]);
  const F ax = Permute(x, corner_a), ay = Permute(y, corner_a);
  const F bx = Permute(x, corner_b), by = Permute(y, corner_b);
  const F cx = Permute(x, corner_c), cy = Permute(y, corner_c);
  const F area_a = cx * by - cy * bx;
  const F area_b = ax * cy - ay * cx;
  const F area_c = bx * ay - by * ax;
  area_a.Store(areas[0]);
  area_b.Store(areas[1]);
  area_c.Store(areas[2]);

  // A triangle is out when it has areas of both signs. What is not a number decides nothing.
  const F zero = F::Broadcast(0);
  const auto is_mixed =
      (Min(Min(area_a, area_b), area_c) < zero) & (zero < Max(Max(area_a, area_b), area_c));
  return leaf.lanes & ~is_mixed.Bits();
}

[[gnu::always_inline]] inline Vec3 LeafVertex(const float (*vertex)[8], uint32_t index) {
  return {vertex[0][index], vertex[1][index], vertex[2][index]};
}

/// Takes the hits among triangles `bits` of a leaf, whose areas are known, and whose vertices are
/// `vertex`. The ray enters the leaf at `entry`. True when a search for any hit is over.
template <class L, bool kAny, bool kChecked>
[[gnu::always_inline]] inline bool FinishTriangles(uint32_t bits, const float (*areas)[8],
                                                   const TriangleLeaf& leaf,
                                                   const float (*vertex)[8], float entry,
                                                   Search<L>* search) {
  const ShearedRay& ray = search->space.sheared;
  while (bits != 0) {
    const int lane = std::countr_zero(bits);
    bits &= bits - 1;
    TriangleHit hit;
    const bool is_hit = FinishTriangle(
        ray, LeafVertex(vertex, leaf.Corner(0, lane)), LeafVertex(vertex, leaf.Corner(1, lane)),
        LeafVertex(vertex, leaf.Corner(2, lane)), {areas[0][lane], areas[1][lane], areas[2][lane]},
        search->space.farthest, &hit);
    if (!is_hit || !search->Counts(entry, &hit.t)) continue;
    const uint32_t* primitive = &search->group->triangle_ids[leaf.first + lane];
    if constexpr (kChecked) {
      const ItemFacts& facts = search->group->items[leaf.item];
      if (!search->PassesFilter(facts, hit.t, hit.u, hit.v, leaf.item, primitive)) continue;
    }
    if (search->Offer(hit.t, hit.u, hit.v, leaf.item, primitive) && kAny) return true;
  }
  return false;
}

template <class L, bool kAny, bool kChecked>
[[gnu::always_inline]] inline bool TestTriangles(const TriangleLeaf& leaf, const float (*vertex)[8],
                                                 float entry, Search<L>* search) {
  alignas(32) float areas[3][8];
  const uint32_t bits = TestEdges<L>(search->space.sheared, leaf, vertex, areas);
  return FinishTriangles<L, kAny, kChecked>(bits, areas, leaf, vertex, entry, search);
}

/// The vertices of a leaf at a time: its own, or blended into `room` when it has time steps.
template <class L>
[[gnu::always_inline]] inline LeafVertices VerticesAt(const TriangleLeaf& leaf, float time,
                                                      float (*room)[8]) {
  using F = typename L::Leaf;
  if (leaf.steps == 1) return leaf.vertex;
  const float position = time * static_cast<float>(leaf.steps - 1);
  const uint32_t last = leaf.steps - 2;
  const uint32_t step = std::min(static_cast<uint32_t>(position), last);
  const float part = position - static_cast<float>(step);
  const F before = F::Broadcast(1 - part), after = F::Broadcast(part);
  // The rows of further steps follow those in the record.
  const std::byte* const first = reinterpret_cast<const std::byte*>(&leaf) + kVertexOffset;
  const float(*rows)[8] = reinterpret_cast<const float(*)[8]>(first) + 3 * step;
  for (int axis = 0; axis < 3; ++axis) {
    (F::Load(rows[axis]) * before + F::Load(rows[axis + 3]) * after).Store(room[axis]);
  }
  return room;
}

/// The same for an item with a mask, a filter or time steps.
template <class L, bool kAny>
bool TestCheckedTriangles(const TriangleLeaf& leaf, float entry, Search<L>* search) {
  if (!search->Sees(leaf.item)) return false;
  alignas(64) float room[3][8];
  const LeafVertices vertex = VerticesAt<L>(leaf, search->Time(), room);
  return TestTriangles<L, kAny, true>(leaf, vertex, entry, search);
}

}  // namespace candela::kernel
