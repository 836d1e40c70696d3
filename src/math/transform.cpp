#include "math/transform.h"

namespace candela {
namespace {

Vec3 Column(const Mat4& a, int j) {
  return ToFloat({a.m[0][j], a.m[1][j], a.m[2][j]});
}

}  // namespace

Transform::Transform(const Mat4& matrix)
    : x_(Column(matrix, 0)),
      y_(Column(matrix, 1)),
      z_(Column(matrix, 2)),
      offset_(Column(matrix, 3)),
      is_translation_(x_ == Vec3{1, 0, 0} && y_ == Vec3{0, 1, 0} && z_ == Vec3{0, 0, 1}) {}

Vec3 Transform::PointError(Vec3 p, Vec3 p_error) const {
  constexpr float kRounding = 3e-7f;  // Three products and three sums: under 5 half-ulps.
  const Vec3 carried = Abs(x_) * p_error.x + Abs(y_) * p_error.y + Abs(z_) * p_error.z;
  const Vec3 rounded = Abs(x_ * p.x) + Abs(y_ * p.y) + Abs(z_ * p.z) + Abs(offset_);
  return carried * (1 + kRounding) + rounded * kRounding;
}

}  // namespace candela
