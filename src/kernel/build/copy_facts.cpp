#include "kernel/build/copy_facts.h"

#include <algorithm>
#include <string>

#include "kernel/group.h"

namespace candela::kernel {
namespace {

/// So that their pieces, and pairs of nodes, can be numbered.
constexpr uint64_t kMostPrimitives = 1u << 30;

}  // namespace

Result<void> CopyFacts(const GroupInput& input, std::span<const BuildItem> items,
                       GroupData* group) {
  uint64_t total = 0;
  for (size_t i = 0; i < input.size(); ++i) {
    const GroupItem& item = input[i];
    ItemFacts& facts = group->items.emplace_back();
    facts.count = items[i].count;
    facts.mask = item.mask;
    group->moves |= items[i].IsMoving();
    total += facts.count;
    if (const auto* triangles = std::get_if<TriangleInput>(&item.content)) {
      if (triangles->steps == 0) {
        return Error{ErrorCode::kUsage, "a mesh needs one time step at least"};
      }
    }
    facts.filter = item.filter;
    if (const auto* primitives = std::get_if<PrimitiveInput>(&item.content)) {
      facts.set = primitives->set;
    } else if (const auto* instance = std::get_if<InstanceInput>(&item.content)) {
      if (auto usable = CheckInstance(item, *instance, *group); !usable) return usable;
      facts.group = instance->group;
      if (instance->world_from_group.size() > 1) {
        facts.motion = MovingInverse(instance->world_from_group);
      }
      group->moves |= facts.group->data().moves;
      group->levels = std::max(group->levels, 1 + facts.group->data().levels);
    }
  }
  if (group->levels > kMostLevels) {
    return Error{ErrorCode::kResources, "groups are nested too deeply: at most " +
                                            std::to_string(HitRecord::kMostNested) +
                                            " inside one another"};
  }
  if (total > kMostPrimitives) {
    return Error{ErrorCode::kResources,
                 "the scene is too large: one group can have 2^30 triangles and other primitives"};
  }
  return {};
}

}  // namespace candela::kernel
