#pragma once

#include "kernel/primitive_test.h"
#include "kernel/search.h"

namespace candela::kernel {

/// Tests the primitives that a group begins with: they need no ray that is prepared for boxes. True
/// when a search for any hit is over.
template <class L, bool kAny>
[[gnu::always_inline]] inline bool TestFirstPrimitives(Search<L>* search) {
  for (const Reference leaf : search->group->first_primitives) {
    const Record* record = search->records + RecordOf(leaf);
    if (TestPrimitives<L, kAny>(*reinterpret_cast<const PrimitiveLeaf*>(record), search->t_min,
                                search)) {
      return true;
    }
  }
  return false;
}

/// Puts the rest of a group on the stack.
template <class L>
[[gnu::always_inline]] inline void PushEntries(Search<L>* search) {
  for (const Reference reference : search->group->entries) {
    search->stack.entry[search->stack.size++] = MakeEntry(search->t_min, reference);
  }
}

/// Begins a search, without the ray's preparation for what is on the stack. False when it is over
/// at once; what it has found counts.
template <class L, bool kAny>
[[gnu::always_inline]] inline bool StartSearch(const GroupData& group, const Ray& ray,
                                               float t_limit, SearchRoom* room, Search<L>* search) {
  if (!search->Begin(group, ray, t_limit, room)) return false;
  if (TestFirstPrimitives<L, kAny>(search)) return false;
  PushEntries(search);
  return search->stack.size > 0;
}

/// The same with it.
template <class L, bool kAny>
[[gnu::always_inline]] inline bool BeginSearch(const GroupData& group, const Ray& ray,
                                               float t_limit, SearchRoom* room, Search<L>* search) {
  if (!StartSearch<L, kAny>(group, ray, t_limit, room, search)) return false;
  search->PrepareOutermost();
  return true;
}

}  // namespace candela::kernel
