#pragma once

#include <bit>

#include "kernel/trace_one.h"

namespace candela::kernel {

/// Sixteen neighbours that go down the tree together: a node is fetched once for all of them, and
/// most of it is passed by with a test of the packet as a whole. Rays whose directions differ in
/// the sign of a component, or in the axis that they follow most, go alone. After Wald, Slusallek,
/// Benthin and Wagner, "Interactive Rendering with Coherent Ray Tracing", 2001, and Boulos, Wald
/// and Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006.
template <class L, bool kAny>
class PacketSearch {
 public:
  static constexpr int kRays = 16;

  /// Begins a ray; `index` below kRays, in order.
  void Begin(int index, const GroupData& group, const Ray& ray, float t_limit) {
    Search<L>& search = search_[index];
    if (search.Begin(group, ray, t_limit)) active_ |= 1u << index;
  }

  const Search<L>& search(int index) const { return search_[index]; }

  void Run(const GroupData& group) {
    if (active_ == 0) return;
    if (group.root == GroupData::kNothing || std::popcount(active_) <= kFewRays || !IsCoherent()) {
      ForEach(active_, [&](int i) { Finish<L, kAny>(&search_[i]); });
      return;
    }
    // The root goes to the packet, what is unbounded stays with the rays.
    ForEach(active_, [&](int i) {
      NodeStack& stack = search_[i].stack;
      stack.entry[0] = stack.entry[--stack.size];
      Finish<L, kAny>(&search_[i]);
    });
    if (kAny) ForEach(active_, [&](int i) { UpdateLimit(i); });
    if (active_ == 0) return;
    records_ = group.records.data();
    Gather();
    Descend(group.root);
  }

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

  bool IsCoherent() const {
    const SpaceRay& first = search_[std::countr_zero(active_)].space;
    bool is_coherent = true;
    ForEach(active_, [&](int i) {
      const SpaceRay& other = search_[i].space;
      for (int axis = 0; axis < 3; ++axis) {
        is_coherent &= other.slabs.near_row[axis] == first.slabs.near_row[axis];
      }
      is_coherent &= other.sheared.kz == first.sheared.kz && other.sheared.kx == first.sheared.kx;
    });
    return is_coherent;
  }

  /// Brings the rays' numbers side by side. Lanes without a ray repeat the first one.
  void Gather() {
    const int first = std::countr_zero(active_);
    for (int i = 0; i < kRays; ++i) {
      const SpaceRay& space = search_[active_ >> i & 1 ? i : first].space;
      for (int axis = 0; axis < 3; ++axis) {
        near_scale_[axis][i] = space.slabs.near_scale[axis];
        near_offset_[axis][i] = space.slabs.near_offset[axis];
        far_scale_[axis][i] = space.slabs.far_scale[axis];
        far_offset_[axis][i] = space.slabs.far_offset[axis];
        origin_[axis][i] = space.sheared.origin[axis];
      }
      shear_[0][i] = space.sheared.shear_x;
      shear_[1][i] = space.sheared.shear_y;
      t_min_[i] = space.slabs.t_min;
      limit_[i] = active_ >> i & 1 ? search_[i].nearest.t : -1;
    }
    const SpaceRay& space = search_[first].space;
    std::copy_n(space.slabs.near_row, 3, near_row_);
    kx_ = space.sheared.kx, ky_ = space.sheared.ky, kz_ = space.sheared.kz;
    UpdateFarthest();

    // Bounds on origins and reciprocals, wider than the slack of any ray.
    constexpr float kOriginSlack = 3e-6f, kSlopeSlack = 2e-6f;
    nearest_t_min_ = Least(t_min_);
    for (int axis = 0; axis < 3; ++axis) {
      alignas(64) float slack[kRays];
      const P scale = P::Load(near_scale_[axis]);
      ((P::Load(near_offset_[axis]) - P::Load(far_offset_[axis])) /
       Max(scale, P::Broadcast(0) - scale))
          .Store(slack);
      const float most_slack = Greatest(slack);
      float o_low = Least(origin_[axis]), o_high = Greatest(origin_[axis]);
      const float s_low = Least(near_scale_[axis]), s_high = Greatest(near_scale_[axis]);
      o_low -= std::abs(o_low) * kOriginSlack + most_slack;
      o_high += std::abs(o_high) * kOriginSlack + most_slack;
      const bool is_negative = s_high < 0;
      frustum_.near_origin[axis] = is_negative ? o_low : o_high;
      frustum_.far_origin[axis] = is_negative ? o_high : o_low;
      frustum_.low_slope[axis] = s_low - std::abs(s_low) * kSlopeSlack;
      frustum_.high_slope[axis] = s_high + std::abs(s_high) * kSlopeSlack;
    }
  }

  /// The least and the greatest of sixteen numbers, halving by halving, which compilers turn into
  /// instructions for several lanes.
  template <class Pick>
  [[gnu::always_inline]] static float Reduce(const float (&all)[kRays], Pick pick) {
    float half[8], quarter[4];
    for (int i = 0; i < 8; ++i) half[i] = pick(all[i], all[i + 8]);
    for (int i = 0; i < 4; ++i) quarter[i] = pick(half[i], half[i + 4]);
    return pick(pick(quarter[0], quarter[1]), pick(quarter[2], quarter[3]));
  }
  static float Least(const float (&all)[kRays]) {
    return Reduce(all, [](float a, float b) { return a < b ? a : b; });
  }
  static float Greatest(const float (&all)[kRays]) {
    return Reduce(all, [](float a, float b) { return a > b ? a : b; });
  }

  void UpdateFarthest() { farthest_ = Greatest(limit_); }

  /// The children that some ray may meet.
  [[gnu::always_inline]] BoxHits<F> TestFrustum(const WideNode<kWidth>& node) const {
    F enter[3], leave[3];
    for (int axis = 0; axis < 3; ++axis) {
      const F low = F::Broadcast(frustum_.low_slope[axis]);
      const F high = F::Broadcast(frustum_.high_slope[axis]);
      const uint32_t row = near_row_[axis];
      const F to_near = F::Load(node.box[row]) - F::Broadcast(frustum_.near_origin[axis]);
      const F to_far = F::Load(node.box[row ^ 1]) - F::Broadcast(frustum_.far_origin[axis]);
      enter[axis] = Min(to_near * low, to_near * high);
      leave[axis] = Max(to_far * low, to_far * high);
    }
    const F entry = Max(Max(enter[0], enter[1]), Max(enter[2], F::Broadcast(nearest_t_min_)));
    const F exit = Min(Min(leave[0], leave[1]), Min(leave[2], F::Broadcast(farthest_)));
    return {entry <= exit, entry};
  }

  /// The rays that meet the box of a child, with the very numbers that each would find alone.
  [[gnu::always_inline]] uint32_t TestChild(const WideNode<kWidth>& node, uint32_t lane) {
    P enter[3], leave[3];
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t row = near_row_[axis];
      enter[axis] = FusedSubtract(P::Broadcast(node.box[row][lane]), P::Load(near_scale_[axis]),
                                  P::Load(near_offset_[axis]));
      leave[axis] = FusedSubtract(P::Broadcast(node.box[row ^ 1][lane]), P::Load(far_scale_[axis]),
                                  P::Load(far_offset_[axis]));
    }
    const P entry = Max(Max(enter[0], enter[1]), Max(enter[2], P::Load(t_min_)));
    const P exit = Min(Min(leave[0], leave[1]), Min(leave[2], P::Load(limit_)));
    entry.Store(entry_);
    return (entry <= exit).Bits();
  }

  void Descend(Reference root) {
    // The root has no parent whose box could be tested.
    for (int i = 0; i < kRays; ++i) entry_[i] = t_min_[i];
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
      Finish<L, kAny>(&search_[i]);
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
      PrefetchRecord<kWidth>(records_, node.child[lane]);
    });
    size_ += count;
  }

  /// The triangles of a leaf against all rays: vertices are sheared for each ray, in the order of
  /// operations that a single ray has.
  void TestLeaf(const TriangleLeaf& leaf, uint32_t rays) {
    alignas(64) float x[8][kRays], y[8][kRays];
    const int kx = kx_, ky = ky_, kz = kz_;
    const P origin_x = P::Load(origin_[kx]), origin_y = P::Load(origin_[ky]);
    const P origin_z = P::Load(origin_[kz]);
    const P shear_x = P::Load(shear_[0]), shear_y = P::Load(shear_[1]);
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
        if (!FinishTriangle(search.space.sheared, corner_a, corner_b, corner_c,
                            {areas[0][i], areas[1][i], areas[2][i]}, &hit) ||
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

  uint32_t active_ = 0;  ///< Bit i: ray i still looks for hits.
  const Record* records_ = nullptr;
  /// The same for all rays. Copies: a ray whose search has ended may be in the space of an
  /// instance.
  uint32_t near_row_[3];
  int kx_ = 0, ky_ = 1, kz_ = 2;
  float farthest_ = 0, nearest_t_min_ = 0;
  struct {
    float near_origin[3], far_origin[3], low_slope[3], high_slope[3];
  } frustum_;
  uint32_t size_ = 0;
  alignas(64) float near_scale_[3][kRays], near_offset_[3][kRays];
  alignas(64) float far_scale_[3][kRays], far_offset_[3][kRays];
  alignas(64) float origin_[3][kRays], shear_[2][kRays];
  alignas(64) float t_min_[kRays], limit_[kRays], entry_[kRays];
  Entry stack_[kMostTreeStack + kWidth];
  Search<L> search_[kRays];
};

template <class L>
void IntersectCoherent(const GroupData& group, const Ray* rays, HitRecord* hits, size_t count) {
  constexpr size_t kRays = PacketSearch<L, false>::kRays;
  for (size_t begin = 0; begin < count; begin += kRays) {
    const int size = static_cast<int>(std::min(kRays, count - begin));
    PacketSearch<L, false> packet;
    for (int i = 0; i < size; ++i) packet.Begin(i, group, rays[begin + i], hits[begin + i].t);
    packet.Run(group);
    for (int i = 0; i < size; ++i) packet.search(i).Report(&hits[begin + i]);
  }
}

template <class L>
void OccludedCoherent(const GroupData& group, const Ray* rays, uint8_t* occluded, size_t count) {
  constexpr size_t kRays = PacketSearch<L, true>::kRays;
  for (size_t begin = 0; begin < count; begin += kRays) {
    const int size = static_cast<int>(std::min(kRays, count - begin));
    PacketSearch<L, true> packet;
    for (int i = 0; i < size; ++i) packet.Begin(i, group, rays[begin + i], rays[begin + i].t_max);
    packet.Run(group);
    for (int i = 0; i < size; ++i) occluded[begin + i] = packet.search(i).HasHit();
  }
}

}  // namespace candela::kernel
