#include "kernel/accelerators/entry_search.h"

#include <algorithm>

#include "geometry/triangle.h"
#include "kernel/accelerators/accelerator.h"
#include "kernel/instance_step.h"
#include "kernel/primitive_test.h"

namespace candela::kernel {
namespace {

/// A vertex at a time between two steps, blended as the lanes of the kernel's leaves are.
Vec3 VertexAt(const EntryTable::Mesh& mesh, uint32_t vertex, float time) {
  if (mesh.steps == 1) return mesh.positions[vertex];
  const size_t count = mesh.positions.size() / mesh.steps;
  const float position = time * static_cast<float>(mesh.steps - 1);
  const uint32_t step = std::min(static_cast<uint32_t>(position), mesh.steps - 2);
  const float part = position - static_cast<float>(step);
  const Vec3* const at_step = &mesh.positions[step * count + vertex];
  return at_step[0] * (1 - part) + at_step[count] * part;
}

}  // namespace

EntrySearch::EntrySearch(const GroupData& group, const Ray& ray, float t_limit, bool any)
    : any_(any) {
  if (!search_.Begin(group, ray, t_limit, &room_)) return;
  search_.PrepareOutermost();
  WalkGroup();
}

PreciseRay EntrySearch::CurrentRay() const {
  PreciseRay ray;
  ray.origin = ToDouble(search_.space.sheared.origin);
  ray.direction = ToDouble(search_.space.sheared.direction);
  ray.t_min = static_cast<double>(search_.t_min);
  ray.rounding = PreciseRay::RoundingOf(static_cast<double>(search_.space.farthest));
  return ray;
}

bool EntrySearch::WalkGroup() {
  const Accelerator& accelerator = *search_.group->structure;
  for (const Entry& entry : accelerator.table().unbounded) {
    if (Test(entry)) return true;
  }
  return accelerator.Walk(this);
}

bool EntrySearch::Test(const Entry& entry) {
  const ItemFacts& facts = search_.group->items[entry.item];
  if (facts.group) return TestInstance(entry.item);
  if (facts.set) {
    return TestPrimitive<Lanes>(search_.CurrentRay(), entry.item, &entry.primitive, search_.t_min,
                                &search_) &&
           any_;
  }
  return TestTriangle(search_.group->structure->table().meshes[entry.item], entry) && any_;
}

bool EntrySearch::TestTriangle(const EntryTable::Mesh& mesh, const Entry& entry) {
  const ItemFacts& facts = search_.group->items[entry.item];
  if ((facts.mask & search_.asked->mask) == 0) return false;
  const auto& [a, b, c] = mesh.triangles[entry.primitive];
  const float time = search_.Time();
  HitRecord hit;
  // A hit as far away as the nearest one may win by its index.
  hit.t = JustAbove<Lanes>(search_.nearest.t);
  if (!IntersectTriangle(search_.space.sheared, search_.t_min, VertexAt(mesh, a, time),
                         VertexAt(mesh, b, time), VertexAt(mesh, c, time), &hit)) {
    return false;
  }
  if (!search_.PassesFilter(facts, hit.t, hit.u, hit.v, entry.item, &entry.primitive)) return false;
  return search_.Offer(hit.t, hit.u, hit.v, entry.item, &entry.primitive);
}

bool EntrySearch::TestInstance(uint32_t item) {
  const Transform& at_rest = search_.group->structure->table().group_from_world[item];
  if (!StepInside<Lanes>(item, at_rest, &search_)) return false;
  const bool is_over = WalkGroup();
  LeaveInstance<Lanes>(&search_);
  return is_over;
}

}  // namespace candela::kernel
