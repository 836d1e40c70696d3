#pragma once

#include "kernel/accelerators/entry_table.h"
#include "kernel/accelerators/precise_ray.h"
#include "kernel/search.h"
#include "kernel/simd/scalar.h"

namespace candela::kernel {

/// One ray on its way through a group with an `Accelerator`, and the groups inside. It tests single
/// entries as `geometry/triangle.h` and the sets define hits, and decides between them as the
/// kernel's own searches do.
class EntrySearch {
 public:
  /// Looks for the nearest hit before `t_limit`, or with `any` for some hit.
  EntrySearch(const GroupData& group, const Ray& ray, float t_limit, bool any);

  /// True and stores it when there is one.
  bool Report(HitRecord* hit) const { return search_.Report(hit); }
  bool HasHit() const { return search_.HasHit(); }

  // For accelerators.

  /// Tests an entry of the table of the group that is searched. True when the search is over.
  bool Test(const Entry& entry);

  /// The ray in the space of that group.
  PreciseRay CurrentRay() const;

  /// Hits up to here, included, are of interest.
  double NearestT() const {
    return static_cast<double>(search_.nearest.t) + PreciseRay::kLeastRounding;
  }

 private:
  using Lanes = scalar::IsaLanes;

  bool WalkGroup();
  bool TestTriangle(const EntryTable::Mesh& mesh, const Entry& entry);
  bool TestInstance(uint32_t item);

  Search<Lanes> search_;
  SearchRoom room_;
  const bool any_;
};

/// Remembers entries that a ray has just been tested with, so that one in many cells is mostly not
/// tested again: a small form of the mailboxes of Amanatides and Woo, 1987, that needs no memory of
/// its own for each entry and thread.
class Mailbox {
 public:
  bool IsNew(uint32_t entry) {
    uint32_t& last = last_[entry % kSize];
    if (last == entry) return false;
    last = entry;
    return true;
  }

 private:
  static constexpr uint32_t kSize = 8;
  static constexpr uint32_t kEmpty = 0xFFFFFFFF;
  uint32_t last_[kSize] = {kEmpty, kEmpty, kEmpty, kEmpty, kEmpty, kEmpty, kEmpty, kEmpty};
};

}  // namespace candela::kernel
