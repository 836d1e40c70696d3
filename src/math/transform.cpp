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

}  // namespace candela
