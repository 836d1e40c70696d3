#pragma once

#include "base/isa.h"

namespace candela::test {

/// Has everything that is built or drawn in its life calculated with an instruction set.
class ForcedIsa {
 public:
  explicit ForcedIsa(Isa isa) { ForceIsa(isa); }
  ~ForcedIsa() { ForceIsa(before_); }
  ForcedIsa(const ForcedIsa&) = delete;
  ForcedIsa& operator=(const ForcedIsa&) = delete;

 private:
  Isa before_ = DefaultIsa();
};

}  // namespace candela::test
