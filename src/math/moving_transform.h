#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "math/mat4.h"
#include "math/transform.h"

namespace candela {

/// a (1 - part) + b part, element by element.
Mat4 Blend(const Mat4& a, const Mat4& b, double part);

/// The matrix at a time in [0, 1], of matrices at times that are evenly spread over it, the ends
/// included: linear in between, element by element. One matrix at least.
Mat4 MatrixAt(std::span<const Mat4> steps, float time);

/// The ways between the world and the space of an object, which may move.
class MovingTransform {
 public:
  struct Pair {
    Transform world_from_object, object_from_world;
  };

  /// Steps as `MatrixAt` has them, of which the first has an inverse.
  explicit MovingTransform(std::vector<Mat4> world_from_object);

  bool IsAtRest() const { return steps_.size() == 1; }
  const std::vector<Mat4>& steps() const { return steps_; }

  /// Both ways at a time; nothing where there is no way back.
  std::optional<Pair> At(float time) const;

 private:
  std::vector<Mat4> steps_;
  Pair first_;
};

}  // namespace candela
