#include "math/transform.h"

namespace candela {
namespace {

Vec3 Column(const Mat4& a, int j) {
  return ToFloat({a.m[0][j], a.m[1][j], a.m[2][j]});
}

}  // namespace

Transform::Transform(const Mat4& matrix)
    : x_(ToFloat4(Column(matrix, 0))),
      y_(ToFloat4(Column(matrix, 1))),
      z_(ToFloat4(Column(matrix, 2))),
      offset_(ToFloat4(Column(matrix, 3))),
      is_translation_(Column(matrix, 0) == Vec3{1, 0, 0} && Column(matrix, 1) == Vec3{0, 1, 0} &&
                      Column(matrix, 2) == Vec3{0, 0, 1}) {}

}  // namespace candela
