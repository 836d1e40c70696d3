#include "kernel/accelerators/build_accelerated.h"

#include <utility>
#include <vector>

#include "base/check.h"
#include "kernel/accelerators/accelerator.h"
#include "kernel/accelerators/brute_force.h"
#include "kernel/accelerators/entry_search.h"
#include "kernel/accelerators/octree.h"
#include "kernel/accelerators/uniform_grid.h"
#include "kernel/build/build_items.h"
#include "kernel/build/copy_facts.h"
#include "kernel/build/fragment.h"
#include "kernel/trace_functions.h"

namespace candela::kernel {
namespace {

bool IntersectOne(const GroupData& group, const Ray& ray, HitRecord* hit) {
  return EntrySearch(group, ray, hit->t, false).Report(hit);
}

bool OccludedOne(const GroupData& group, const Ray& ray) {
  return EntrySearch(group, ray, ray.t_max, true).HasHit();
}

void IntersectList(const GroupData& group, const Ray* rays, HitRecord* hits, size_t count) {
  for (size_t i = 0; i < count; ++i) IntersectOne(group, rays[i], &hits[i]);
}

void OccludedList(const GroupData& group, const Ray* rays, uint8_t* occluded, size_t count) {
  for (size_t i = 0; i < count; ++i) occluded[i] = OccludedOne(group, rays[i]);
}

/// Lists are as quick as single rays.
constexpr TraceFunctions kFunctions = {
    8, &IntersectOne, &OccludedOne, &IntersectList, &OccludedList, &IntersectList, &OccludedList};

}  // namespace

std::shared_ptr<const Accelerator> MakeAccelerator(AcceleratorKind kind, EntryTable table,
                                                   std::span<const Bounds3> boxes,
                                                   const CancelToken* cancel) {
  switch (kind) {
    case AcceleratorKind::kGrid:
      return std::make_shared<UniformGrid>(std::move(table), boxes, cancel);
    case AcceleratorKind::kOctree:
      return std::make_shared<Octree>(std::move(table), boxes, cancel);
    default:
      CHECK(kind == AcceleratorKind::kNone);
      return std::make_shared<BruteForce>(std::move(table));
  }
}

Result<GroupData> BuildAccelerated(const GroupInput& input, const BuildOptions& options) {
  GroupData group;
  group.accelerator = options.accelerator;
  group.trace = &kFunctions;
  const std::vector<BuildItem> items = MakeBuildItems(input);
  if (const auto facts = CopyFacts(input, items, &group); !facts) return facts.error();
  try {
    StopWhenCancelled(options.cancel);
    std::vector<Bounds3> boxes;
    EntryTable table = MakeEntryTable(items, options.cancel, &boxes);
    for (const Bounds3& box : boxes) group.bounds.Extend(box);
    group.structure = MakeAccelerator(options.accelerator, std::move(table), boxes, options.cancel);
  } catch (const BuildStopped&) {
    return Error{ErrorCode::kStopped, "stopped on request"};
  }
  return group;
}

}  // namespace candela::kernel
