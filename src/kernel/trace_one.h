#pragma once

#include "kernel/box_test.h"
#include "kernel/child_order.h"
#include "kernel/instance_step.h"
#include "kernel/primitive_test.h"
#include "kernel/search.h"
#include "kernel/triangle_test.h"

namespace candela::kernel {

/// Looks at something that is neither a node nor a plain triangle leaf. True when the search is over.
template <class L, bool kAny>
[[gnu::noinline]] bool VisitOther(StackEntry entry, Search<L>* search) {
  const Reference reference = ReferenceOf(entry);
  const Record* record = search->records + RecordOf(reference);
  switch (KindOf(reference)) {
    case RecordKind::kCheckedTriangles:
      return TestCheckedTriangles<L, kAny>(*reinterpret_cast<const TriangleLeaf*>(record),
                                           EntryOf(entry), search);
    case RecordKind::kPrimitives:
      return TestPrimitives<L, kAny>(*reinterpret_cast<const PrimitiveLeaf*>(record),
                                     EntryOf(entry), search);
    case RecordKind::kInstance:
      EnterInstance<L>(*reinterpret_cast<const InstanceLeaf*>(record), search);
      return false;
    case RecordKind::kLeaveInstance:
      LeaveInstance<L>(search);
      return false;
    case RecordKind::kMovingNode: {
      using F = typename L::Node;
      const auto& node = *reinterpret_cast<const MovingNode<L::kWidth>*>(record);
      const auto hits =
          TestBoxes(WideSlabs<F>(search->space.slabs), search->space.slabs, node,
                    F::Broadcast(search->nearest.t), search->Time());
      if (hits.bits == 0) return false;
      NodeStack* stack = &search->stack;
      const StackEntry next =
          OrderChildren<L::kWidth, true>(hits, node.child, search->records, stack);
      stack->entry[stack->size++] = next;
      return false;
    }
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
    const Slabs& slabs = search->space.slabs;
    const WideSlabs<F> wide(slabs);
    const Record* const records = search->records;
    const int level = search->level;
    while (search->level == level) {
      if (stack->size == 0) return;
      StackEntry entry = stack->entry[--stack->size];
      // At equal distance something may still win by its index.
      if (EntryOf(entry) > search->nearest.t) continue;

      bool is_inside = true;
      while (IsNode(ReferenceOf(entry))) {
        const auto& node =
            *reinterpret_cast<const WideNode<L::kWidth>*>(records + ReferenceOf(entry));
        const auto hits = TestBoxes(wide, slabs, node, F::Broadcast(search->nearest.t));
        if (hits.bits == 0) {
          is_inside = false;
          break;
        }
        entry = OrderChildren<L::kWidth, true>(hits, node.child, records, stack);
      }
      if (!is_inside) continue;

      const Reference reference = ReferenceOf(entry);
      if (KindOf(reference) == RecordKind::kTriangles) [[likely]] {
        const auto& leaf =
            *reinterpret_cast<const TriangleLeaf*>(records + RecordOf(reference));
        if (TestTriangles<L, kAny, false>(leaf, leaf.vertex, EntryOf(entry), search) && kAny) {
          return;
        }
      } else if (VisitOther<L, kAny>(entry, search)) {
        return;
      }
    }
  }
}

template <class L>
bool IntersectOne(const GroupData& group, const Ray& ray, HitRecord* hit) {
  Search<L> search;
  if (!search.Begin(group, ray, hit->t)) return false;
  Finish<L, false>(&search);
  return search.Report(hit);
}

template <class L>
bool OccludedOne(const GroupData& group, const Ray& ray) {
  Search<L> search;
  if (!search.Begin(group, ray, ray.t_max)) return false;
  Finish<L, true>(&search);
  return search.HasHit();
}

}  // namespace candela::kernel
