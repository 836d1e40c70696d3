#pragma once

#include <bit>
#include <utility>

#include "kernel/trace_one.h"

namespace candela::kernel {

/// Many rays in flight on one thread, each taking one step in its turn: while one waits for its next
/// record to come from memory, the others work. After Kocberber, Falsafi and Grot, "Asynchronous
/// Memory Access Chaining", 2015. Since turns leave no pattern that a branch predictor could learn,
/// steps have as few branches as possible: rays that look at the same kind of record take their
/// turns together, and children are put in order by a sorting network.
template <class L, bool kAny>
class SpanSearch {
 public:
  static constexpr uint32_t kInFlight = 32;

  SpanSearch(const GroupData& group, const Ray* rays, size_t count)
      : group_(group), rays_(rays), count_(count) {}

  /// Calls `report(index, search)` for each ray when it is done. `limit(index)` is how far a ray
  /// goes.
  template <class Limit, class Report>
  void Run(Limit limit, Report report) {
    for (uint32_t i = 0; i < kInFlight; ++i) TakeNext(i, limit, report);
    while (waiting_[kNodes].size + waiting_[kTriangles].size + waiting_[kOthers].size > 0) {
      ForAllOf(kNodes, [&](uint32_t i) {
        StepIntoNode(&slots_[i].search);
        Advance(i, limit, report);
      });
      ForAllOf(kTriangles, [&](uint32_t i) {
        Search<L>* search = &slots_[i].search;
        const auto& leaf = *reinterpret_cast<const TriangleLeaf*>(
            search->records + RecordOf(search->current.reference));
        const bool is_over =
            TestTriangles<L, kAny, false>(leaf, leaf.vertex, search->current.entry, search);
        if (kAny && is_over) search->stack.size = 0;
        Advance(i, limit, report);
      });
      ForAllOf(kOthers, [&](uint32_t i) {
        Search<L>* search = &slots_[i].search;
        const bool is_over = VisitOther<L, kAny>(search->current.reference,
                                                 search->current.entry, search);
        if (kAny && is_over) search->stack.size = 0;
        Advance(i, limit, report);
      });
    }
  }

 private:
  struct Slot {
    Search<L> search;
    size_t index;
  };

  /// The slots whose current record is of one kind.
  enum Kind : uint32_t { kNodes, kTriangles, kOthers, kKinds };
  struct List {
    uint32_t size = 0;
    uint8_t slot[kInFlight];
  };

  /// Calls `step` for each slot on a list, which begins a new list.
  template <class Step>
  void ForAllOf(Kind kind, Step step) {
    const List list = waiting_[kind];
    waiting_[kind].size = 0;
    for (uint32_t i = 0; i < list.size; ++i) step(list.slot[i]);
  }

  /// Starts the next ray that can hit anything, if one is left.
  template <class Limit, class Report>
  void TakeNext(uint32_t slot, Limit limit, Report report) {
    while (next_ < count_) {
      Search<L>* search = &slots_[slot].search;
      const size_t index = next_++;
      slots_[slot].index = index;
      if (search->Begin(group_, rays_[index], limit(index)) && Pop(search)) {
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

  [[gnu::always_inline]] void Enqueue(uint32_t slot) {
    const auto kind = static_cast<uint32_t>(KindOf(slots_[slot].search.current.reference));
    List& list = waiting_[std::min<uint32_t>(kind, kOthers)];
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
      PrefetchRecord<L::kWidth>(search->records, ReferenceOf(entry));
      return true;
    }
    stack.size = 0;
    return false;
  }

  /// Puts the children that are met on the stack, from far to near.
  [[gnu::always_inline]] static void StepIntoNode(Search<L>* search) {
    using F = typename L::Node;
    const auto& node = *reinterpret_cast<const WideNode<L::kWidth>*>(search->records +
                                                                     search->current.reference);
    const Slabs& slabs = search->space.slabs;
    const auto hits =
        TestBoxes(WideSlabs<F>(slabs), slabs, node, F::Broadcast(search->nearest.t));
    NodeStack& stack = search->stack;
    const F child = F::Load(reinterpret_cast<const float*>(node.child));
    const uint32_t bits = hits.mask.Bits();
    const auto count = static_cast<uint32_t>(std::popcount(bits));
    StackEntry* const top = stack.entry + stack.size;
    if constexpr (L::kWidth == 8) {
      const auto order = OrderFarToNear(hits.entry, hits.mask);
      StorePairs(Permute(child, order), Permute(hits.entry, order), top);
    } else {
      if (count > 8) [[unlikely]] {
        const NextChild next = OrderChildren<L::kWidth, false>(bits, hits.entry, node.child,
                                                               search->records, &stack);
        stack.entry[stack.size++] = MakeEntry(next.entry, next.reference);
        return;
      }
      const auto entry = Compact(hits.entry, hits.mask);
      const auto order = OrderFarToNear(entry, L::Leaf::Mask::FromBits((1u << count) - 1));
      StorePairs(Permute(Compact(child, hits.mask), order), Permute(entry, order), top);
    }
    stack.size += count;
  }

  const GroupData& group_;
  const Ray* rays_;
  size_t count_;
  size_t next_ = 0;
  List waiting_[kKinds];
  Slot slots_[kInFlight];
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
