#include "kernel/accelerators/brute_force.h"

#include "kernel/accelerators/entry_search.h"

namespace candela::kernel {

bool BruteForce::Walk(EntrySearch* search) const {
  for (const Entry& entry : table().entries) {
    if (search->Test(entry)) return true;
  }
  return false;
}

}  // namespace candela::kernel
