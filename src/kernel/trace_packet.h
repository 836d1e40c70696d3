#pragma once

#include <bit>

#include "kernel/packet_rays.h"
#include "kernel/trace_one.h"
#include "kernel/trace_span.h"

namespace candela::kernel {

/// Sixteen neighbours that go down the tree together: a node is fetched once for all of them, and
/// most of it is passed by with a test of the packet as a whole. Rays whose directions differ in
/// the sign of a component, or in the axis that they follow most, go alone. After Wald, Slusallek,
/// Benthin and Wagner, "Interactive Rendering with Coherent Ray Tracing", 2001, and Boulos, Wald
/// and Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006.
template <class L, bool kAny>
class PacketSearch {
 public:
  static constexpr int kRays = PacketRays<L>::kRays;

  /// Follows up to kRays rays to the end; `limit(i)` is how far ray i goes.
  template <class Limit>
  void Run(const GroupData& group, const Ray* rays, int count, Limit limit) {
    active_ = prepared_ = sheared_ = 0;
    for (int i = 0; i < count; ++i) {
      if (StartSearch<L, kAny>(group, rays[i], limit(i), &rooms_[i], &search_[i])) {
        active_ |= 1u << i;
      }
    }
    if (active_ == 0) return;
    const bool has_tree = group.entries[0] == group.root;
    if (!has_tree || std::popcount(active_) <= kFewRays ||
        !rays_.Set(search_, active_, group.largest_coordinate)) {
      ForEach(active_, [&](int i) { FinishAlone(i); });
      return;
    }
    std::fill_n(limit_, kRays, -1.0f);
    // The root goes to the packet, instances without bounds stay with the rays.
    ForEach(active_, [&](int i) {
      NodeStack& stack = search_[i].stack;
      stack.entry[0] = stack.entry[--stack.size];
      if (stack.size > 0) FinishAlone(i);
      UpdateLimit(i);
    });
    records_ = group.records.data();
    UpdateFarthest();
    Descend(group.root);
  }

  const Search<L>& search(int index) const { return search_[index]; }

 private:
  using P = typename L::Packet;
  using F = typename L::Node;
  static constexpr int kWidth = L::kWidth;
  static constexpr int kFewRays = 1;  ///< So many are quicker one by one.

  /// A child of a node, and the distance before which no ray of the packet enters it.
  struct Entry {
    float entry;
    uint32_t lane;
    const WideNode<kWidth>* node;
  };

  template <class Function>
  [[gnu::always_inline]] static void ForEach(uint32_t bits, Function function) {
    for (; bits != 0; bits &= bits - 1) function(std::countr_zero(bits));
  }

  /// Lets a ray take care of its own stack.
  void FinishAlone(int i) {
    if ((prepared_ >> i & 1) == 0) {
      prepared_ |= 1u << i;
      search_[i].PrepareOutermost();
    }
    Finish<L, kAny>(&search_[i]);
  }

  /// A ray as the tests of triangles want it.
  const ShearedRay& Sheared(int i) {
    if (((prepared_ | sheared_) >> i & 1) == 0) {
      sheared_ |= 1u << i;
      rays_.StoreSheared(i, *search_[i].asked, &search_[i].space.sheared);
    }
    return search_[i].space.sheared;
  }

  void UpdateFarthest() { farthest_ = PacketRays<L>::Greatest(limit_); }

  /// The children that some ray may meet.
  [[gnu::always_inline]] BoxHits<F> TestFrustum(const WideNode<kWidth>& node) const {
    F enter[3], leave[3];
    for (int axis = 0; axis < 3; ++axis) {
      const F low = F::Broadcast(rays_.frustum.low_slope[axis]);
      const F high = F::Broadcast(rays_.frustum.high_slope[axis]);
      const uint32_t row = rays_.near_row[axis];
      const F to_near = F::Load(node.box[row]) - F::Broadcast(rays_.frustum.near_origin[axis]);
      const F to_far = F::Load(node.box[row ^ 1]) - F::Broadcast(rays_.frustum.far_origin[axis]);
      enter[axis] = Min(to_near * low, to_near * high);
      leave[axis] = Max(to_far * low, to_far * high);
    }
    const F entry = Max(Max(enter[0], enter[1]), Max(enter[2], F::Broadcast(rays_.nearest_t_min)));
    const F exit = Min(Min(leave[0], leave[1]), Min(leave[2], F::Broadcast(farthest_)));
    return {entry <= exit, entry};
  }

  /// The rays that meet the box of a child, with the very numbers that each would find alone.
  [[gnu::always_inline]] uint32_t TestChild(const WideNode<kWidth>& node, uint32_t lane) {
    P enter[3], leave[3];
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t row = rays_.near_row[axis];
      enter[axis] =
          FusedSubtract(P::Broadcast(node.box[row][lane]), P::Load(rays_.near_scale[axis]),
                        P::Load(rays_.near_offset[axis]));
      leave[axis] = FusedSubtract(P::Broadcast(node.box[row ^ 1][lane]),
                                  P::Load(rays_.far_scale[axis]), P::Load(rays_.far_offset[axis]));
    }
    const P entry = Max(Max(enter[0], enter[1]), Max(enter[2], P::Load(rays_.t_min)));
    const P exit = Min(Min(leave[0], leave[1]), Min(leave[2], P::Load(limit_)));
    entry.Store(entry_);
    return (entry <= exit).Bits();
  }

  void Descend(Reference root) {
    size_ = 0;
    // The root has no parent whose box could be tested.
    for (int i = 0; i < kRays; ++i) entry_[i] = rays_.t_min[i];
    Visit(root, active_);
    while (size_ > 0 && active_ != 0) {
      const Entry next = stack_[--size_];
      if (next.entry > farthest_) continue;
      const uint32_t rays = TestChild(*next.node, next.lane) & active_;
      if (rays != 0) Visit(next.node->child[next.lane], rays);
    }
  }

  /// Looks at what a reference leads to, for `rays`, which enter it at `entry_`.
  void Visit(Reference reference, uint32_t rays) {
    if (IsNode(reference) && std::popcount(rays) > kFewRays) {
      PushChildren(*reinterpret_cast<const WideNode<kWidth>*>(records_ + reference));
      return;
    }
    if (KindOf(reference) == RecordKind::kTriangles && std::popcount(rays) > kFewRays) {
      TestLeaf(*reinterpret_cast<const TriangleLeaf*>(records_ + RecordOf(reference)), rays);
      return;
    }
    ForEach(rays, [&](int i) {
      NodeStack& stack = search_[i].stack;
      stack.entry[stack.size++] = MakeEntry(entry_[i], reference);
      FinishAlone(i);
      UpdateLimit(i);
    });
    UpdateFarthest();
  }

  /// Takes over what ray i has found; in a search for any hit it is done then.
  void UpdateLimit(int i) {
    limit_[i] = search_[i].nearest.t;
    if (kAny && search_[i].HasHit()) {
      active_ &= ~(1u << i);
      limit_[i] = -1;
    }
  }

  void PushChildren(const WideNode<kWidth>& node) {
    const BoxHits<F> hits = TestFrustum(node);
    alignas(64) float entry[kWidth];
    hits.entry.Store(entry);
    Entry* const base = stack_ + size_;
    uint32_t count = 0;
    ForEach(hits.mask.Bits(), [&](int lane) {
      uint32_t place = count++;
      for (; place > 0 && base[place - 1].entry < entry[lane]; --place) {
        base[place] = base[place - 1];
      }
      base[place] = {entry[lane], static_cast<uint32_t>(lane), &node};
      PrefetchRecord<L>(records_, node.child[lane]);
    });
    size_ += count;
  }

  /// The triangles of a leaf against all rays: vertices are sheared for each ray, in the order of
  /// operations that a single ray has.
  void TestLeaf(const TriangleLeaf& leaf, uint32_t rays) {
    alignas(64) float x[8][kRays], y[8][kRays];
    const int kx = rays_.kx, ky = rays_.ky, kz = rays_.kz;
    const P origin_x = P::Load(rays_.origin[kx]), origin_y = P::Load(rays_.origin[ky]);
    const P origin_z = P::Load(rays_.origin[kz]);
    const P shear_x = P::Load(rays_.shear[0]), shear_y = P::Load(rays_.shear[1]);
    for (int i = 0; i < 8; ++i) {
      const P to_z = P::Broadcast(leaf.vertex[kz][i]) - origin_z;
      ((P::Broadcast(leaf.vertex[kx][i]) - origin_x) + to_z * shear_x).Store(x[i]);
      ((P::Broadcast(leaf.vertex[ky][i]) - origin_y) + to_z * shear_y).Store(y[i]);
    }
    bool has_changed = false;
    ForEach(leaf.lanes, [&](int lane) {
      const uint32_t a = leaf.Corner(0, lane), b = leaf.Corner(1, lane), c = leaf.Corner(2, lane);
      const P ax = P::Load(x[a]), ay = P::Load(y[a]);
      const P bx = P::Load(x[b]), by = P::Load(y[b]);
      const P cx = P::Load(x[c]), cy = P::Load(y[c]);
      const P area_a = cx * by - cy * bx;
      const P area_b = ax * cy - ay * cx;
      const P area_c = bx * ay - by * ax;
      const P zero = P::Broadcast(0);
      const auto is_mixed =
          (Min(Min(area_a, area_b), area_c) < zero) & (zero < Max(Max(area_a, area_b), area_c));
      const uint32_t candidates = rays & (kAny ? active_ : ~0u) & ~is_mixed.Bits();
      if (candidates == 0) return;
      alignas(64) float areas[3][kRays];
      area_a.Store(areas[0]);
      area_b.Store(areas[1]);
      area_c.Store(areas[2]);
      const Vec3 corner_a = LeafVertex(leaf.vertex, a), corner_b = LeafVertex(leaf.vertex, b),
                 corner_c = LeafVertex(leaf.vertex, c);
      ForEach(candidates, [&](int i) {
        Search<L>& search = search_[i];
        TriangleHit hit;
        if (!FinishTriangle(Sheared(i), corner_a, corner_b, corner_c,
                            {areas[0][i], areas[1][i], areas[2][i]}, rays_.farthest, &hit) ||
            !search.Counts(entry_[i], &hit.t) ||
            !search.Offer(hit.t, hit.u, hit.v, leaf.item,
                          &search.group->triangle_ids[leaf.first + static_cast<uint32_t>(lane)])) {
          return;
        }
        has_changed = true;
        UpdateLimit(i);
      });
    });
    if (has_changed) UpdateFarthest();
  }

  uint32_t active_ = 0;    ///< Bit i: ray i still looks for hits,
  uint32_t prepared_ = 0;  ///< is prepared for all tests,
  uint32_t sheared_ = 0;   ///< for those of triangles.
  const Record* records_ = nullptr;
  PacketRays<L> rays_;
  float farthest_ = 0;
  uint32_t size_ = 0;
  alignas(64) float limit_[kRays], entry_[kRays];
  Entry stack_[kMostTreeStack + kWidth];
  Search<L> search_[kRays];
  SearchRoom rooms_[kRays];
};

template <class L>
void IntersectCoherent(const GroupData& group, const Ray* rays, HitRecord* hits, size_t count) {
  if (L::kMoves && !IsNode(group.root)) return IntersectScattered<L>(group, rays, hits, count);
  constexpr size_t kRays = PacketSearch<L, false>::kRays;
  PacketSearch<L, false> packet;
  for (size_t begin = 0; begin < count; begin += kRays) {
    const int size = static_cast<int>(std::min(kRays, count - begin));
    packet.Run(group, rays + begin, size, [&](int i) { return hits[begin + i].t; });
    for (int i = 0; i < size; ++i) packet.search(i).Report(&hits[begin + i]);
  }
}

template <class L>
void OccludedCoherent(const GroupData& group, const Ray* rays, uint8_t* occluded, size_t count) {
  if (L::kMoves && !IsNode(group.root)) return OccludedScattered<L>(group, rays, occluded, count);
  constexpr size_t kRays = PacketSearch<L, true>::kRays;
  PacketSearch<L, true> packet;
  for (size_t begin = 0; begin < count; begin += kRays) {
    const int size = static_cast<int>(std::min(kRays, count - begin));
    packet.Run(group, rays + begin, size, [&](int i) { return rays[begin + i].t_max; });
    for (int i = 0; i < size; ++i) occluded[begin + i] = packet.search(i).HasHit();
  }
}

}  // namespace candela::kernel
