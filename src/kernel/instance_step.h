#pragma once

#include "kernel/enter_group.h"

namespace candela::kernel {

/// Takes a ray into the space that a moving instance's group has at a time; where the matrix on the
/// way has no inverse nothing of the group is there, and the direction becomes 0. Compiled once,
/// for all instruction sets.
void TakeInsideAt(const ItemFacts& facts, float time, Vec3* origin, Vec3* direction);

/// Takes the ray into the space of an instance's group, where t stays what it is. False when there
/// is nothing for it there.
template <class L>
[[gnu::always_inline]] inline bool StepInside(uint32_t item, const Transform& at_rest,
                                              Search<L>* search) {
  const ItemFacts& facts = search->group->items[item];
  if ((facts.mask & search->asked->mask) == 0) return false;
  Vec3 origin = search->space.sheared.origin, direction = search->space.sheared.direction;
  if (facts.motion.steps().empty()) {
    origin = at_rest.Point(origin);
    direction = at_rest.Vector(direction);
  } else {
    TakeInsideAt(facts, search->Time(), &origin, &direction);
  }
  if (!IsTraceable<L>(origin, direction)) return false;

  search->outer[search->level] = {search->group, search->space};
  search->path[search->level] = item;
  ++search->level;
  search->group = &facts.group->data();
  search->records = search->group->records.data();
  search->space.template Set<L>(origin, direction, search->t_min,
                                search->group->largest_coordinate);
  return true;
}

/// The same for a search by trees: the group's tree goes on the stack above a mark. True when a
/// search for any hit is over.
template <class L, bool kAny>
bool EnterInstance(const InstanceLeaf& leaf, Search<L>* search) {
  if (!StepInside<L>(leaf.item, leaf.group_from_world, search)) return false;
  search->stack.entry[search->stack.size++] =
      MakeEntry(0, MakeReference(RecordKind::kLeaveInstance, 0));
  if (TestFirstPrimitives<L, kAny>(search)) return true;
  PushEntries(search);
  return false;
}

/// Goes back to where the ray came from.
template <class L>
void LeaveInstance(Search<L>* search) {
  --search->level;
  search->group = search->outer[search->level].group;
  search->records = search->group->records.data();
  search->space = search->outer[search->level].space;
}

}  // namespace candela::kernel
