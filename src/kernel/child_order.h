#pragma once

#include <bit>

#include "kernel/box_test.h"
#include "kernel/node_stack.h"

namespace candela::kernel {

/// Brings what a record will need into the cache while there is other work.
template <int W>
[[gnu::always_inline]] inline void PrefetchRecord(const Record* records, Reference reference) {
  const char* address = reinterpret_cast<const char*>(records + RecordOf(reference));
  const int bytes = IsNode(reference) ? static_cast<int>(sizeof(WideNode<W>)) : 128;
  for (int line = 0; line < bytes; line += 64) __builtin_prefetch(address + line);
}

/// Picks the nearest of the children that were met, `bits` not 0, as the next one, and puts the
/// others on the stack, the nearest last. One and two are the usual numbers and come first, with
/// branches: a predicted branch lets the next record be fetched before the distances are known.
/// With `kPrefetch` the others are fetched, too.
template <int W, bool kPrefetch, class F>
[[gnu::always_inline]] inline StackEntry OrderChildren(const BoxHits<F>& hits,
                                                       const Reference* child,
                                                       const Record* records, NodeStack* stack) {
  alignas(64) float entry[F::kCount];
  hits.entry.Store(entry);
  uint32_t bits = hits.bits;
  const auto take = [&] {
    const int lane = std::countr_zero(bits);
    bits &= bits - 1;
    return MakeEntry(entry[lane], child[lane]);
  };

  const StackEntry first = take();
  if (bits == 0) return first;

  const StackEntry second = take();
  if (bits == 0) {
    if (first < second) {
      if (kPrefetch) PrefetchRecord<W>(records, ReferenceOf(second));
      stack->entry[stack->size++] = second;
      return first;
    }
    if (kPrefetch) PrefetchRecord<W>(records, ReferenceOf(first));
    stack->entry[stack->size++] = first;
    return second;
  }

  // Insertion into the upper part of the stack, which stays ordered from far to near.
  StackEntry* const base = stack->entry + stack->size;
  base[0] = first > second ? first : second;
  base[1] = first > second ? second : first;
  uint32_t count = 2;
  do {
    const StackEntry next = take();
    uint32_t place = count++;
    for (; place > 0 && base[place - 1] < next; --place) base[place] = base[place - 1];
    base[place] = next;
  } while (bits != 0);
  if (kPrefetch) {
    for (uint32_t i = 0; i + 1 < count; ++i) PrefetchRecord<W>(records, ReferenceOf(base[i]));
  }
  stack->size += count - 1;
  return base[count - 1];
}

}  // namespace candela::kernel
