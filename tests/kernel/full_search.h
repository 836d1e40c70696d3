#pragma once

#include <map>
#include <memory>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "tests/kernel/group_description.h"

namespace candela::test {

/// `Group::Intersect` without a tree: looks at everything, in the order of the indices, and
/// computes each hit as `geometry/triangle.h` and the sets do. The description has to outlive it.
class FullSearch {
 public:
  explicit FullSearch(const GroupDescription& group);
  ~FullSearch();

  bool Intersect(const Ray& ray, HitRecord* hit) const;

 private:
  struct Prepared;
  class Query;

  const Prepared* Prepare(const GroupDescription& group);

  /// Groups inside stand there once, however many instances of them there are.
  std::map<const GroupDescription*, std::unique_ptr<Prepared>> prepared_;
  const Prepared* outermost_;
};

}  // namespace candela::test
