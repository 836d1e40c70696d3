#include "math/moving_transform.h"

#include <algorithm>
#include <cstddef>

#include "base/check.h"

namespace candela {
namespace {

/// Where in two or more moments that are evenly spread over the times from 0 to 1 a time is: by
/// `part` of the way from the one of that index to the next one.
struct TimeStep {
  TimeStep(size_t moments, float time) {
    const double position = double{time} * static_cast<double>(moments - 1);
    index = std::min(static_cast<size_t>(position), moments - 2);
    part = position - static_cast<double>(index);
  }
  size_t index;
  double part;
};

bool HaveSameLinearPart(const Mat4& a, const Mat4& b) {
  for (size_t row = 0; row < 3; ++row) {
    if (!std::equal(a.m[row].begin(), a.m[row].begin() + 3, b.m[row].begin())) return false;
  }
  return true;
}

}  // namespace

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
  const TimeStep step(steps.size(), time);
  return Blend(steps[step.index], steps[step.index + 1], step.part);
}

MovingInverse::MovingInverse(std::vector<Mat4> world_from_object)
    : steps_(std::move(world_from_object)) {
  if (steps_.size() < 2 || !std::ranges::all_of(steps_, [this](const Mat4& step) {
        return HaveSameLinearPart(step, steps_.front());
      })) {
    return;
  }
  std::vector<Vec3d> offsets;
  for (const Mat4& step : steps_) {
    const auto inverse = InverseAffine(step);
    if (!inverse) return;
    offsets.push_back({inverse->m[0][3], inverse->m[1][3], inverse->m[2][3]});
    linear_ = Transform(*inverse);
  }
  offsets_ = std::move(offsets);
}

std::optional<Transform> MovingInverse::At(float time) const {
  if (!offsets_.empty()) {
    const TimeStep step(offsets_.size(), time);
    return linear_.WithOffset(
        ToFloat(offsets_[step.index] * (1 - step.part) + offsets_[step.index + 1] * step.part));
  }
  const auto inverse = InverseAffine(MatrixAt(steps_, time));
  if (!inverse) return std::nullopt;
  return Transform(*inverse);
}

MovingTransform::MovingTransform(std::vector<Mat4> world_from_object)
    : inverse_(std::move(world_from_object)) {
  const auto inverse = InverseAffine(steps().front());
  CHECK(inverse);
  first_ = {Transform(steps().front()), Transform(*inverse)};
}

std::optional<MovingTransform::Pair> MovingTransform::At(float time) const {
  if (IsAtRest()) return first_;
  const auto object_from_world = inverse_.At(time);
  if (!object_from_world) return std::nullopt;
  return Pair{Transform(MatrixAt(steps(), time)), *object_from_world};
}

}  // namespace candela
