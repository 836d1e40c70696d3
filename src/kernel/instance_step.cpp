#include "kernel/instance_step.h"

#include "math/moving_transform.h"

namespace candela::kernel {

Transform GroupFromWorldAt(const ItemFacts& facts, float time) {
  // A matrix on the way may have no inverse; then nothing of the group is there.
  const auto inverse = InverseAffine(MatrixAt(facts.steps, time));
  return inverse ? Transform(*inverse) : Transform(Mat4{});
}

}  // namespace candela::kernel
