#pragma once

#include <bit>

#include "kernel/box_test.h"
#include "kernel/node_stack.h"

namespace candela::kernel {

/// Brings what a record will need into the cache while there is other work.
template <class L>
[[gnu::always_inline]] inline void PrefetchRecord(const Record* records, Reference reference) {
  const char* address = reinterpret_cast<const char*>(records + RecordOf(reference));
  int bytes = IsNode(reference) ? static_cast<int>(sizeof(WideNode<L::kWidth>)) : 128;
  if constexpr (L::kMoves) {
    const RecordKind kind = KindOf(reference);
    if (kind == RecordKind::kMovingNode) bytes = sizeof(MovingNode<L::kWidth>);
    if (kind == RecordKind::kCheckedTriangles) bytes = TriangleLeafRecords(2) * sizeof(Record);
  }
  for (int line = 0; line < bytes; line += 64) __builtin_prefetch(address + line);
}

/// What a search looks at next. Its distance stays apart from the reference, which is known earlier
/// and is what the next load waits for.
struct NextChild {
  Reference reference;
  float entry;
};

/// Picks the nearest of the children that were met, `bits` not 0, as the next one, and puts the
/// others on the stack, the nearest last; with `kPrefetch` those are fetched, too. One and two
/// are the usual numbers and come first, with branches: a predicted branch lets the next record be
/// fetched before the distances are known.
template <class L, bool kPrefetch, class F>
[[gnu::always_inline]] inline NextChild OrderChildren(uint32_t bits, F entries,
                                                      const Reference* child, const Record* records,
                                                      NodeStack* stack) {
  alignas(64) float entry[F::kCount];
  entries.Store(entry);
  const int first = std::countr_zero(bits);
  bits &= bits - 1;
  if (bits == 0) return {child[first], entry[first]};

  const int second = std::countr_zero(bits);
  bits &= bits - 1;
  if (bits == 0) {
    const Reference one = child[first], two = child[second];
    if (entry[first] <= entry[second]) {
      if (kPrefetch) PrefetchRecord<L>(records, two);
      stack->entry[stack->size++] = MakeEntry(entry[second], two);
      return {one, entry[first]};
    }
    if (kPrefetch) PrefetchRecord<L>(records, one);
    stack->entry[stack->size++] = MakeEntry(entry[first], one);
    return {two, entry[second]};
  }

  // Insertion into the upper part of the stack, which stays ordered from far to near.
  StackEntry* const base = stack->entry + stack->size;
  const StackEntry one = MakeEntry(entry[first], child[first]);
  const StackEntry two = MakeEntry(entry[second], child[second]);
  base[0] = one > two ? one : two;
  base[1] = one > two ? two : one;
  uint32_t count = 2;
  do {
    const int lane = std::countr_zero(bits);
    bits &= bits - 1;
    const StackEntry next = MakeEntry(entry[lane], child[lane]);
    uint32_t place = count++;
    for (; place > 0 && base[place - 1] < next; --place) base[place] = base[place - 1];
    base[place] = next;
  } while (bits != 0);
  if (kPrefetch) {
    for (uint32_t i = 0; i + 1 < count; ++i) PrefetchRecord<L>(records, ReferenceOf(base[i]));
  }
  stack->size += count - 1;
  const StackEntry nearest = base[count - 1];
  return {ReferenceOf(nearest), EntryOf(nearest)};
}

/// The same without an order, for searches that any hit ends.
template <class L, class F>
[[gnu::always_inline]] inline NextChild KeepChildren(uint32_t bits, F entries,
                                                     const Reference* child, const Record* records,
                                                     NodeStack* stack) {
  alignas(64) float entry[F::kCount];
  entries.Store(entry);
  const int first = std::countr_zero(bits);
  for (bits &= bits - 1; bits != 0; bits &= bits - 1) {
    const int lane = std::countr_zero(bits);
    PrefetchRecord<L>(records, child[lane]);
    stack->entry[stack->size++] = MakeEntry(entry[lane], child[lane]);
  }
  return {child[first], entry[first]};
}

}  // namespace candela::kernel
