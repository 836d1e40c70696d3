#pragma once

#include "kernel/search.h"

namespace candela::kernel {

/// Tests a primitive behind the two-function interface. `ray` is the one of the current group;
/// `primitive` has to stay where it is. True when it is the nearest hit now.
template <class L>
[[gnu::always_inline]] inline bool TestPrimitive(const Ray& ray, uint32_t item,
                                                 const uint32_t* primitive, float entry,
                                                 Search<L>* search) {
  const ItemFacts& facts = search->group->items[item];
  if ((facts.mask & search->asked->mask) == 0) return false;
  HitRecord hit;
  // A hit as far away as the nearest one may win by its index.
  hit.t = JustAbove<L>(search->nearest.t);
  if (!facts.set->IntersectPrimitive(ray, *primitive, &hit)) return false;
  if (!search->Counts(entry, &hit.t) ||
      !search->PassesFilter(facts, hit.t, hit.u, hit.v, item, primitive)) {
    return false;
  }
  return search->Offer(hit.t, hit.u, hit.v, item, primitive);
}

/// Tests the primitives of a leaf. True when a search for any hit is over.
template <class L, bool kAny>
bool TestPrimitives(const PrimitiveLeaf& leaf, float entry, Search<L>* search) {
  const Ray ray = search->CurrentRay();
  for (uint32_t i = 0; i < leaf.count; ++i) {
    const auto& [item, primitive] = leaf.entry[i];
    if (TestPrimitive<L>(ray, item, &primitive, entry, search) && kAny) return true;
  }
  return false;
}

}  // namespace candela::kernel
