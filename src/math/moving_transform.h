#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "math/mat4.h"
#include "math/transform.h"
#include "math/vec.h"

namespace candela {

/// a (1 - part) + b part, element by element.
Mat4 Blend(const Mat4& a, const Mat4& b, double part);

/// The matrix at a time in [0, 1], of matrices at times that are evenly spread over it, the ends
/// included: linear in between, element by element. One matrix at least.
Mat4 MatrixAt(std::span<const Mat4> steps, float time);

/// The way from the world into a space that moves.
class MovingInverse {
 public:
  /// There are no steps.
  MovingInverse() = default;
  /// `world_from_object` is at times as `MatrixAt` has them.
  explicit MovingInverse(std::vector<Mat4> world_from_object);

  const std::vector<Mat4>& steps() const { return steps_; }
  uint64_t MemoryBytes() const {
    return steps_.capacity() * sizeof(Mat4) + offsets_.capacity() * sizeof(Vec3d);
  }

  /// At a time in [0, 1], of one step at least; nothing where there is no way back.
  std::optional<Transform> At(float time) const;

 private:
  std::vector<Mat4> steps_;
  /// Where all steps have the same linear part, its inverse, and the offsets of their inverses: the
  /// inverse of a matrix on the way is on the way between theirs.
  Transform linear_;
  std::vector<Vec3d> offsets_;
};

/// The ways between the world and the space of an object, which may move.
class MovingTransform {
 public:
  struct Pair {
    Transform world_from_object, object_from_world;
  };

  /// Steps as `MatrixAt` has them, of which the first has an inverse.
  explicit MovingTransform(std::vector<Mat4> world_from_object);

  bool IsAtRest() const { return steps().size() == 1; }
  const std::vector<Mat4>& steps() const { return inverse_.steps(); }
  uint64_t MemoryBytes() const { return sizeof *this + inverse_.MemoryBytes(); }

  /// Both ways at a time; nothing where there is no way back.
  std::optional<Pair> At(float time) const;

 private:
  MovingInverse inverse_;
  Pair first_;
};

}  // namespace candela
