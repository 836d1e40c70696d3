#pragma once

#include <memory>

#include "kernel/trace_one.h"

namespace candela::kernel {

/// Many rays in flight on one thread, each taking one step in its turn: while one waits for its next
/// record to come from memory, the others work. After Kocberber, Falsafi and Grot, "Asynchronous
/// Memory Access Chaining", 2015.
template <class L, bool kAny>
class SpanSearch {
 public:
  static constexpr int kInFlight = 32;

  SpanSearch(const GroupData& group, const Ray* rays, size_t count)
      : group_(group), rays_(rays), count_(count) {}

  /// Calls `report(index, search)` for each ray when it is done. `limit(index)` is how far a ray
  /// goes.
  template <class Limit, class Report>
  void Run(Limit limit, Report report) {
    int active = 0;
    for (; active < kInFlight; ++active) {
      if (!TakeNext(&slots_[active], limit, report)) break;
    }
    while (active > 0) {
      for (int i = 0; i < active;) {
        Slot& slot = slots_[order_[i]];
        if (Step(&slot.search)) {
          report(slot.index, slot.search);
          if (!TakeNext(&slot, limit, report)) {
            std::swap(order_[i], order_[--active]);
            continue;
          }
        }
        ++i;
      }
    }
  }

 private:
  struct Slot {
    Search<L> search;
    size_t index;
  };

  /// Starts the next ray that can hit anything; false when none is left.
  template <class Limit, class Report>
  bool TakeNext(Slot* slot, Limit limit, Report report) {
    while (next_ < count_) {
      slot->index = next_++;
      if (slot->search.Begin(group_, rays_[slot->index], limit(slot->index)) &&
          Pop(&slot->search)) {
        return true;
      }
      report(slot->index, slot->search);
    }
    return false;
  }

  /// Takes the next thing from the stack that is not too far; false when there is none.
  static bool Pop(Search<L>* search) {
    NodeStack& stack = search->stack;
    while (stack.size > 0) {
      const StackEntry entry = stack.entry[--stack.size];
      if (EntryOf(entry) > search->nearest.t) continue;
      search->current = {ReferenceOf(entry), EntryOf(entry)};
      PrefetchRecord<L::kWidth>(search->records, ReferenceOf(entry));
      return true;
    }
    return false;
  }

  /// One record of one ray. True when the ray is done.
  static bool Step(Search<L>* search) {
    using F = typename L::Node;
    const auto [reference, entry] = search->current;
    if (IsNode(reference)) {
      const auto& node =
          *reinterpret_cast<const WideNode<L::kWidth>*>(search->records + reference);
      const Slabs& slabs = search->space.slabs;
      const auto hits = TestBoxes(WideSlabs<F>(slabs), slabs, node,
                                  F::Broadcast(search->nearest.t));
      if (hits.bits == 0) return !Pop(search);
      search->current = OrderChildren<L::kWidth, false>(hits, node.child, search->records,
                                                        &search->stack);
      PrefetchRecord<L::kWidth>(search->records, search->current.reference);
      return false;
    }
    if (KindOf(reference) == RecordKind::kTriangles) {
      const auto& leaf =
          *reinterpret_cast<const TriangleLeaf*>(search->records + RecordOf(reference));
      if (TestTriangles<L, kAny, false>(leaf, leaf.vertex, entry, search) && kAny) {
        return true;
      }
    } else if (VisitOther<L, kAny>(reference, entry, search)) {
      return true;
    }
    return !Pop(search);
  }

  const GroupData& group_;
  const Ray* rays_;
  size_t count_;
  size_t next_ = 0;
  uint8_t order_[kInFlight] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
                               16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
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
