#pragma once

#include <bit>
#include <type_traits>
#include <utility>

#include "kernel/trace_one.h"

namespace candela::kernel {

/// Many rays in flight on one thread, each taking one step in its turn: while one waits for its
/// next record to come from memory, the others work. After Kocberber, Falsafi and Grot,
/// "Asynchronous Memory Access Chaining", 2015. Since turns leave no pattern that a branch
/// predictor could learn, steps have as few branches as possible: rays that look at the same kind
/// of record take their turns together, and children are put in order by a sorting network.
template <class L, bool kAny>
class SpanSearch {
 public:
  static constexpr uint32_t kInFlight = 24;
  /// Rays that take a step together: their instructions do not wait for each other's.
  static constexpr uint32_t kTogether = 4;

  SpanSearch(const GroupData& group, const Ray* rays, size_t count)
      : group_(group), rays_(rays), count_(count) {}

  /// Calls `report(index, search)` for each ray when it is done. `limit(index)` is how far a ray
  /// goes.
  template <class Limit, class Report>
  void Run(Limit limit, Report report) {
    for (uint32_t i = 0; i < kInFlight; ++i) TakeNext(i, limit, report);
    while (HasWaiting()) {
      StepAll<WideNode<L::kWidth>>(kNodes, limit, report);
      TestAll<false>(kTriangles, limit, report);
      if constexpr (L::kMoves) {
        StepAll<MovingNode<L::kWidth>>(kMovingNodes, limit, report);
        TestAll<true>(kCheckedTriangles, limit, report);
      }
      ForAllOf(kOthers, [&]<uint32_t kCount>(const uint8_t* slots, Times<kCount>) {
        for (uint32_t k = 0; k < kCount; ++k) {
          Search<L>* search = &slots_[slots[k]].search;
          const bool is_over =
              VisitOther<L, kAny>(search->current.reference, search->current.entry, search);
          if (kAny && is_over) search->stack.size = 0;
          Advance(slots[k], limit, report);
        }
      });
    }
  }

 private:
  struct Slot {
    Search<L> search;
    size_t index;
  };

  /// The slots whose current record is of one kind. The last two are others where nothing moves.
  enum Kind : uint32_t { kNodes, kTriangles, kOthers, kMovingNodes, kCheckedTriangles };
  static constexpr uint32_t kKinds = L::kMoves ? 5 : 3;
  struct List {
    uint32_t size = 0;
    uint8_t slot[kInFlight];
  };

  /// A number that the compiler knows.
  template <uint32_t kCount>
  using Times = std::integral_constant<uint32_t, kCount>;

  /// Calls `step` for the slots on a list, several at a time, while a new list begins.
  template <class Step>
  [[gnu::always_inline]] void ForAllOf(Kind kind, Step step) {
    const List list = waiting_[kind];
    waiting_[kind].size = 0;
    uint32_t i = 0;
    for (; i + kTogether <= list.size; i += kTogether) step(list.slot + i, Times<kTogether>());
    for (; i < list.size; ++i) step(list.slot + i, Times<1>());
  }

  /// Lets all slots on a list of nodes take their step,
  template <class Node, class Limit, class Report>
  [[gnu::always_inline]] void StepAll(Kind kind, Limit limit, Report report) {
    ForAllOf(
        kind, [&]<uint32_t kCount>(const uint8_t* slots, Times<kCount>)
                  __attribute__((always_inline)) {
                    StepIntoNodes<Node, kCount>(slots);
                    for (uint32_t k = 0; k < kCount; ++k) Advance(slots[k], limit, report);
                  });
  }

  /// and all on a list of triangle leaves.
  template <bool kChecked, class Limit, class Report>
  [[gnu::always_inline]] void TestAll(Kind kind, Limit limit, Report report) {
    ForAllOf(
        kind, [&]<uint32_t kCount>(const uint8_t* slots, Times<kCount>)
                  __attribute__((always_inline)) {
                    TestLeaves<kChecked, kCount>(slots);
                    for (uint32_t k = 0; k < kCount; ++k) Advance(slots[k], limit, report);
                  });
  }

  /// Starts the next ray that can hit anything, if one is left.
  template <class Limit, class Report>
  void TakeNext(uint32_t slot, Limit limit, Report report) {
    while (next_ < count_) {
      Search<L>* search = &slots_[slot].search;
      const size_t index = next_++;
      slots_[slot].index = index;
      if (BeginSearch<L, kAny>(group_, rays_[index], limit(index), &rooms_[slot], search) &&
          Pop(search)) {
        Enqueue(slot);
        return;
      }
      report(index, *search);
    }
  }

  /// Goes on with what is next for a ray, or with the next ray.
  template <class Limit, class Report>
  [[gnu::always_inline]] void Advance(uint32_t slot, Limit limit, Report report) {
    if (Pop(&slots_[slot].search)) [[likely]] {
      Enqueue(slot);
      return;
    }
    report(slots_[slot].index, slots_[slot].search);
    TakeNext(slot, limit, report);
  }

  /// The list for a kind of record.
  [[gnu::always_inline]] static uint32_t WaitsAs(RecordKind kind) {
    if constexpr (L::kMoves) {
      if (kind == RecordKind::kMovingNode) return kMovingNodes;
      if (kind == RecordKind::kCheckedTriangles) return kCheckedTriangles;
    }
    return std::min<uint32_t>(static_cast<uint32_t>(kind), kOthers);
  }

  bool HasWaiting() const {
    uint32_t sum = 0;
    for (const List& list : waiting_) sum += list.size;
    return sum > 0;
  }

  [[gnu::always_inline]] void Enqueue(uint32_t slot) {
    const RecordKind kind = KindOf(slots_[slot].search.current.reference);
    List& list = waiting_[WaitsAs(kind)];
    list.slot[list.size++] = static_cast<uint8_t>(slot);
  }

  /// Takes the next thing from the stack that is not too far; false when there is none.
  [[gnu::always_inline]] static bool Pop(Search<L>* search) {
    NodeStack& stack = search->stack;
    const float limit = search->nearest.t;
    for (uint32_t size = stack.size; size > 0;) {
      const StackEntry entry = stack.entry[--size];
      if (EntryOf(entry) > limit) continue;
      stack.size = size;
      search->current = {ReferenceOf(entry), EntryOf(entry)};
      PrefetchRecord<L>(search->records, ReferenceOf(entry));
      return true;
    }
    stack.size = 0;
    return false;
  }

  /// Puts the children that are met on the stacks of so many rays, from far to near. Several at
  /// once have no part that waits for the other's.
  template <class Node, uint32_t kCount>
  [[gnu::always_inline]] void StepIntoNodes(const uint8_t* slots) {
    using F = typename L::Node;
    constexpr bool kMoving = std::is_same_v<Node, MovingNode<L::kWidth>>;
    Search<L>* search[kCount];
    const Node* node[kCount];
    F entry[kCount];
    typename F::Mask mask[kCount];
    for (uint32_t k = 0; k < kCount; ++k) {
      search[k] = &slots_[slots[k]].search;
      const Reference reference = search[k]->current.reference;
      const uint32_t record = kMoving ? RecordOf(reference) : reference;
      node[k] = reinterpret_cast<const Node*>(search[k]->records + record);
      const auto hits = TestNode<L>(WideSlabs<F>(search[k]->space.slabs), *node[k], *search[k]);
      entry[k] = hits.entry;
      mask[k] = hits.mask;
    }
    uint32_t count[kCount];
    typename L::Leaf near[kCount], child[kCount];
    for (uint32_t k = 0; k < kCount; ++k) {
      const uint32_t bits = mask[k].Bits();
      count[k] = static_cast<uint32_t>(std::popcount(bits));
      const F children = F::Load(reinterpret_cast<const float*>(node[k]->child));
      if constexpr (L::kWidth == 8) {
        const auto order = OrderFarToNear(entry[k], mask[k]);
        near[k] = Permute(entry[k], order);
        child[k] = Permute(children, order);
      } else {
        if (count[k] > 8) [[unlikely]] {
          NodeStack* stack = &search[k]->stack;
          const NextChild next =
              OrderChildren<L, false>(bits, entry[k], node[k]->child, search[k]->records, stack);
          stack->entry[stack->size++] = MakeEntry(next.entry, next.reference);
          count[k] = 0;
        }
        near[k] = Compact(entry[k], mask[k]);
        child[k] = Compact(children, mask[k]);
        if (kAny) continue;  // Whatever is hit ends the search: the order counts for little.
        const auto order = OrderFarToNear(near[k], L::Leaf::Mask::FromBits((1u << count[k]) - 1));
        near[k] = Permute(near[k], order);
        child[k] = Permute(child[k], order);
      }
    }
    for (uint32_t k = 0; k < kCount; ++k) {
      NodeStack& stack = search[k]->stack;
      StorePairs(child[k], near[k], stack.entry + stack.size);
      stack.size += count[k];
    }
  }

  /// Tests the leaves of so many rays.
  template <bool kChecked, uint32_t kCount>
  [[gnu::always_inline]] void TestLeaves(const uint8_t* slots) {
    alignas(64) float areas[kCount][3][8];
    alignas(64) float room[kChecked ? kCount : 1][3][8];
    LeafVertices blended[kCount];
    uint32_t candidates[kCount];
    for (uint32_t k = 0; k < kCount; ++k) {
      const Search<L>& search = slots_[slots[k]].search;
      const TriangleLeaf& leaf = CurrentLeaf(search);
      if constexpr (kChecked) {
        blended[k] = VerticesAt<L>(leaf, search.Time(), room[k]);
        candidates[k] = TestEdges<L>(search.space.sheared, leaf, blended[k], areas[k]);
        if (!search.Sees(leaf.item)) candidates[k] = 0;
      } else {
        candidates[k] = TestEdges<L>(search.space.sheared, leaf, leaf.vertex, areas[k]);
      }
    }
    for (uint32_t k = 0; k < kCount; ++k) {
      Search<L>* search = &slots_[slots[k]].search;
      const TriangleLeaf& leaf = CurrentLeaf(*search);
      const bool is_over = FinishTriangles<L, kAny, kChecked>(candidates[k], areas[k], leaf,
                                                              kChecked ? blended[k] : leaf.vertex,
                                                              search->current.entry, search);
      if (kAny && is_over) search->stack.size = 0;
    }
  }

  static const TriangleLeaf& CurrentLeaf(const Search<L>& search) {
    return *reinterpret_cast<const TriangleLeaf*>(search.records +
                                                  RecordOf(search.current.reference));
  }

  const GroupData& group_;
  const Ray* rays_;
  size_t count_;
  size_t next_ = 0;
  List waiting_[kKinds];
  Slot slots_[kInFlight];
  SearchRoom rooms_[kInFlight];
};

template <class L>
void IntersectScattered(const GroupData& group, const Ray* rays, HitRecord* hits, size_t count) {
  SpanSearch<L, false>(group, rays, count)
      .Run([&](size_t i) { return hits[i].t; },
           [&](size_t i, const Search<L>& search) { search.Report(&hits[i]); });
}

template <class L>
void OccludedScattered(const GroupData& group, const Ray* rays, uint8_t* occluded, size_t count) {
  SpanSearch<L, true>(group, rays, count)
      .Run([&](size_t i) { return rays[i].t_max; },
           [&](size_t i, const Search<L>& search) { occluded[i] = search.HasHit(); });
}

}  // namespace candela::kernel
