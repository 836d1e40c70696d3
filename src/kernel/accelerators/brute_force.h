#pragma once

#include "kernel/accelerators/accelerator.h"

namespace candela::kernel {

/// No structure: a ray is tested with every entry. What the others are compared with.
class BruteForce final : public Accelerator {
 public:
  using Accelerator::Accelerator;
  bool Walk(EntrySearch* search) const override;
};

}  // namespace candela::kernel
