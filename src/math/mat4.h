#pragma once

#include <array>
#include <optional>

#include "math/vec.h"

namespace candela {

/// A 4x4 matrix in double precision for column vectors: p' = m * p, composed right to left. Scenes
/// are composed in double and rounded once, into a `Transform`.
struct Mat4 {
  std::array<std::array<double, 4>, 4> m;  ///< m[row][column]

  static Mat4 Identity();
  static Mat4 Translate(Vec3d offset);
  static Mat4 Scale(Vec3d factors);
  /// Counter-clockwise by `degrees` about the positive axis 0, 1 or 2, seen against the axis.
  static Mat4 Rotate(int axis, double degrees);

  friend bool operator==(const Mat4&, const Mat4&) = default;
};

Mat4 operator*(const Mat4& a, const Mat4& b);

/// The inverse of an affine matrix (last row 0 0 0 1), or nothing when it is singular: when the
/// inverse or the matrix itself is not finite in single precision.
std::optional<Mat4> InverseAffine(const Mat4& a);

}  // namespace candela
