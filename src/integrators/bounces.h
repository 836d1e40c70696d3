#pragma once

#include <array>
#include <cstdint>

namespace candela {

struct IntegratorOptions;

/// What a surface does with a path; each has a limit of its own.
enum BounceKind : uint8_t { kDiffuse, kMirror, kTransmission };

inline BounceKind KindOf(bool is_delta, bool is_transmission) {
  if (is_transmission) return kTransmission;
  return is_delta ? kMirror : kDiffuse;
}

/// How often surfaces have scattered a path; holes that it has gone through do not count.
struct BounceCounts {
  uint32_t all = 0;
  std::array<uint32_t, 3> of_kind{};

  void Add(BounceKind kind) {
    ++all;
    ++of_kind[kind];
  }
};

/// How often they may.
struct BounceLimits {
  explicit BounceLimits(const IntegratorOptions& options);

  bool Allow(const BounceCounts& counts) const { return counts.all < all; }
  bool Allow(const BounceCounts& counts, BounceKind kind) const {
    return counts.of_kind[kind] < of_kind[kind];
  }

  uint32_t all;
  std::array<uint32_t, 3> of_kind;
};

}  // namespace candela
