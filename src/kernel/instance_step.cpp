#include "kernel/instance_step.h"

#include <algorithm>

namespace candela::kernel {

Transform GroupFromWorldAt(const ItemFacts& facts, float time) {
  const double position = double{time} * static_cast<double>(facts.steps.size() - 1);
  const auto step = std::min(static_cast<size_t>(position), facts.steps.size() - 2);
  const double part = position - static_cast<double>(step);
  Mat4 world_from_group;
  for (size_t row = 0; row < 4; ++row) {
    for (size_t column = 0; column < 4; ++column) {
      world_from_group.m[row][column] = facts.steps[step].m[row][column] * (1 - part) +
                                        facts.steps[step + 1].m[row][column] * part;
    }
  }
  // A matrix on the way may have no inverse; then nothing of the group is there.
  const auto inverse = InverseAffine(world_from_group);
  return inverse ? Transform(*inverse) : Transform(Mat4{});
}

}  // namespace candela::kernel
