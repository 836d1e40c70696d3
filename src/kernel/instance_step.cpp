#include "kernel/instance_step.h"

namespace candela::kernel {

void TakeInsideAt(const ItemFacts& facts, float time, Vec3* origin, Vec3* direction) {
  const auto group_from_world = facts.motion.At(time);
  *origin = group_from_world ? group_from_world->Point(*origin) : Vec3{};
  *direction = group_from_world ? group_from_world->Vector(*direction) : Vec3{};
}

}  // namespace candela::kernel
