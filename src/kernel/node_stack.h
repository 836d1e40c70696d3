#pragma once

#include <bit>
#include <cstdint>

#include "kernel/group_data.h"

namespace candela::kernel {

/// Something still to be looked at: where, and the distance at which the ray enters its box. As one
/// number, that orders by distance first: bits of floats that are not negative grow with them.
using StackEntry = uint64_t;

[[gnu::always_inline]] inline StackEntry MakeEntry(float t, Reference reference) {
  return static_cast<uint64_t>(std::bit_cast<uint32_t>(t)) << 32 | reference;
}
[[gnu::always_inline]] inline Reference ReferenceOf(StackEntry entry) {
  return static_cast<Reference>(entry);
}
[[gnu::always_inline]] inline float EntryOf(StackEntry entry) {
  return std::bit_cast<float>(static_cast<uint32_t>(entry >> 32));
}

/// What a search still has to look at, the nearest last. The builder keeps trees within kMostStack
/// entries.
struct NodeStack {
  uint32_t size = 0;
  StackEntry* entry = nullptr;
};

}  // namespace candela::kernel
