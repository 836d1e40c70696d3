#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Draws one of n things, each as often as its weight says, in the same short time for any n: Vose,
/// "A Linear Algorithm for Generating Random Numbers with a Given Distribution", 1991. The same
/// weights give the same table everywhere. Immutable.
class AliasTable {
 public:
  /// Weights are finite and not negative, and at least one is above 0.
  explicit AliasTable(std::span<const double> weights);

  struct Choice {
    uint32_t index;
    double rest;  ///< In [0, 1): what the choice has left of the number, evenly spread again.
  };
  /// `u` is in [0, 1). In double: of many things each takes only a few steps of a float.
  Choice Draw(double u) const;

  size_t size() const { return slots_.size(); }
  uint64_t MemoryBytes() const { return slots_.capacity() * sizeof(Slot); }

 private:
  /// Each slot is drawn equally often.
  struct Slot {
    float keep;  ///< The part of its draws that stay with it; the others go to the alias.
    uint32_t alias;
  };
  std::vector<Slot> slots_;
};

}  // namespace candela
