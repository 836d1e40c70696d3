#pragma once

#include "kernel/box_test.h"
#include "kernel/child_order.h"
#include "kernel/instance_step.h"
#include "kernel/primitive_test.h"
#include "kernel/search.h"
#include "kernel/triangle_test.h"

namespace candela::kernel {

/// Whether a reference leads to a node, of one kind or the other.
template <class L>
[[gnu::always_inline]] inline bool IsInner(Reference reference) {
  return IsNode(reference) || (L::kMoves && KindOf(reference) == RecordKind::kMovingNode);
}

/// Tests the boxes of a node.
template <class L>
[[gnu::always_inline]] inline BoxHits<typename L::Node> TestNode(
    const WideSlabs<typename L::Node>& wide, const WideNode<L::kWidth>& node,
    const Search<L>& search) {
  return TestBoxes(wide, search.space.slabs, node, L::Node::Broadcast(search.nearest.t));
}
template <class L>
[[gnu::always_inline]] inline BoxHits<typename L::Node> TestNode(
    const WideSlabs<typename L::Node>& wide, const MovingNode<L::kWidth>& node,
    const Search<L>& search) {
  return TestBoxes(wide, search.space.slabs, node, L::Node::Broadcast(search.nearest.t),
                   search.Time());
}

/// Looks at something that is neither a node nor a plain triangle leaf. True when the search is
/// over.
template <class L, bool kAny>
[[gnu::noinline]] bool VisitOther(Reference reference, float entry, Search<L>* search) {
  const Record* record = search->records + RecordOf(reference);
  switch (KindOf(reference)) {
    case RecordKind::kCheckedTriangles:
      return TestCheckedTriangles<L, kAny>(*reinterpret_cast<const TriangleLeaf*>(record), entry,
                                           search);
    case RecordKind::kPrimitives:
      return TestPrimitives<L, kAny>(*reinterpret_cast<const PrimitiveLeaf*>(record), entry,
                                     search);
    case RecordKind::kInstance:
      return EnterInstance<L, kAny>(*reinterpret_cast<const InstanceLeaf*>(record), search);
    case RecordKind::kLeaveInstance:
      LeaveInstance<L>(search);
      return false;
    default:
      return false;
  }
}

/// Follows one ray to the end. With `kAny` the first hit ends it, else the nearest is kept.
template <class L, bool kAny>
void Finish(Search<L>* search) {
  using F = typename L::Node;
  NodeStack* const stack = &search->stack;
  while (true) {
    // The loop below belongs to one group; it is left to enter or leave an instance.
    const WideSlabs<F> wide(search->space.slabs);
    const Record* const records = search->records;
    const int level = search->level;
    while (search->level == level) {
      if (stack->size == 0) return;
      const StackEntry top = stack->entry[--stack->size];
      // At equal distance something may still win by its index.
      if (EntryOf(top) > search->nearest.t) continue;

      NextChild next = {ReferenceOf(top), EntryOf(top)};
      const auto goes_on = [&](const auto& node) __attribute__((always_inline)) {
        const auto hits = TestNode<L>(wide, node, *search);
        const uint32_t bits = hits.mask.Bits();
        if (bits == 0) return false;
        if constexpr (kAny) {
          next = KeepChildren<L>(bits, hits.entry, node.child, records, stack);
        } else {
          next = OrderChildren<L, true>(bits, hits.entry, node.child, records, stack);
        }
        return true;
      };
      bool is_missed = false;
      while (IsInner<L>(next.reference)) {
        if (L::kMoves && !IsNode(next.reference)) {
          const Record* const record = records + RecordOf(next.reference);
          is_missed = !goes_on(*reinterpret_cast<const MovingNode<L::kWidth>*>(record));
        } else {
          const Record* const record = records + next.reference;
          is_missed = !goes_on(*reinterpret_cast<const WideNode<L::kWidth>*>(record));
        }
        if (is_missed) break;
      }
      if (is_missed) continue;

      if (KindOf(next.reference) == RecordKind::kTriangles) [[likely]] {
        const auto& leaf =
            *reinterpret_cast<const TriangleLeaf*>(records + RecordOf(next.reference));
        if (TestTriangles<L, kAny, false>(leaf, leaf.vertex, next.entry, search) && kAny) return;
      } else if (VisitOther<L, kAny>(next.reference, next.entry, search)) {
        return;
      }
    }
  }
}

template <class L>
bool IntersectOne(const GroupData& group, const Ray& ray, HitRecord* hit) {
  Search<L> search;
  SearchRoom room;
  if (BeginSearch<L, false>(group, ray, hit->t, &room, &search)) Finish<L, false>(&search);
  return search.Report(hit);
}

template <class L>
bool OccludedOne(const GroupData& group, const Ray& ray) {
  Search<L> search;
  SearchRoom room;
  if (BeginSearch<L, true>(group, ray, ray.t_max, &room, &search)) Finish<L, true>(&search);
  return search.HasHit();
}

}  // namespace candela::kernel
