#include "math/moving_transform.h"

#include <algorithm>
#include <cstddef>

#include "base/check.h"

namespace candela {

Mat4 Blend(const Mat4& a, const Mat4& b, double part) {
  Mat4 blend;
  for (size_t row = 0; row < 4; ++row) {
    for (size_t column = 0; column < 4; ++column) {
      blend.m[row][column] = a.m[row][column] * (1 - part) + b.m[row][column] * part;
    }
  }
  return blend;
}

Mat4 MatrixAt(std::span<const Mat4> steps, float time) {
  if (steps.size() == 1) return steps[0];
  const double position = double{time} * static_cast<double>(steps.size() - 1);
  const auto step = std::min(static_cast<size_t>(position), steps.size() - 2);
  return Blend(steps[step], steps[step + 1], position - static_cast<double>(step));
}

MovingTransform::MovingTransform(std::vector<Mat4> world_from_object)
    : steps_(std::move(world_from_object)) {
  const auto inverse = InverseAffine(steps_.front());
  CHECK(inverse);
  first_ = {Transform(steps_.front()), Transform(*inverse)};
}

std::optional<MovingTransform::Pair> MovingTransform::At(float time) const {
  if (IsAtRest()) return first_;
  const Mat4 world_from_object = MatrixAt(steps_, time);
  const auto inverse = InverseAffine(world_from_object);
  if (!inverse) return std::nullopt;
  return Pair{Transform(world_from_object), Transform(*inverse)};
}

}  // namespace candela
