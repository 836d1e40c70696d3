#pragma once

#include "kernel/search.h"

namespace candela::kernel {

/// Tests primitives behind the two-function interface. True when a search for any hit is over.
template <class L, bool kAny>
bool TestPrimitives(const PrimitiveLeaf& leaf, float entry, Search<L>* search) {
  const Ray ray = search->CurrentRay();
  for (uint32_t i = 0; i < leaf.count; ++i) {
    const auto& [item, primitive] = leaf.entry[i];
    const ItemFacts& facts = search->group->items[item];
    if ((facts.mask & search->asked->mask) == 0) continue;
    HitRecord hit;
    // A hit as far away as the nearest one may win by its index.
    hit.t = JustAbove<L>(search->nearest.t);
    if (!facts.set->IntersectPrimitive(ray, primitive, &hit)) continue;
    if (!search->Counts(entry, &hit.t) ||
        !search->PassesFilter(facts, hit.t, hit.u, hit.v, item, &leaf.entry[i].primitive)) {
      continue;
    }
    if (search->Offer(hit.t, hit.u, hit.v, item, &leaf.entry[i].primitive) && kAny) return true;
  }
  return false;
}

}  // namespace candela::kernel
