#include "math/mat4.h"

#include "math/elementary.h"

namespace candela {
namespace {

bool FitsFloat(const Mat4& a) {
  bool fits = true;  // All are looked at, which takes less time than to go as soon as one does not.
  for (const auto& row : a.m) {
    for (const double value : row) {
      fits &= std::abs(static_cast<float>(value)) <= std::numeric_limits<float>::max();
    }
  }
  return fits;
}

}  // namespace

Mat4 Mat4::Identity() {
  return Scale({1, 1, 1});
}

Mat4 Mat4::Translate(Vec3d offset) {
  return {{{{1, 0, 0, offset.x}, {0, 1, 0, offset.y}, {0, 0, 1, offset.z}, {0, 0, 0, 1}}}};
}

Mat4 Mat4::Scale(Vec3d factors) {
  return {{{{factors.x, 0, 0, 0}, {0, factors.y, 0, 0}, {0, 0, factors.z, 0}, {0, 0, 0, 1}}}};
}

Mat4 Mat4::Rotate(int axis, double degrees) {
  const double c = CosDegrees(degrees);
  const double s = SinDegrees(degrees);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Mat4 r = Identity();
  r.m[u][u] = c;
  r.m[u][v] = -s;
  r.m[v][u] = s;
  r.m[v][v] = c;
  return r;
}

Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 product;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      product.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j] +
                        a.m[i][3] * b.m[3][j];
    }
  }
  return product;
}

std::optional<Mat4> InverseAffine(const Mat4& a) {
  // The inverse of the linear part is its adjugate over the determinant; its rows are the cross
  // products of the columns.
  const auto column = [&](int j) { return Vec3d{a.m[0][j], a.m[1][j], a.m[2][j]}; };
  const Vec3d c0 = column(0), c1 = column(1), c2 = column(2), offset = column(3);
  const double determinant = Dot(c0, Cross(c1, c2));
  if (!(determinant != 0) || !std::isfinite(determinant)) return std::nullopt;

  const Vec3d rows[3] = {Cross(c1, c2) / determinant, Cross(c2, c0) / determinant,
                         Cross(c0, c1) / determinant};
  Mat4 inverse = Mat4::Identity();
  for (int i = 0; i < 3; ++i) {
    inverse.m[i] = {rows[i].x, rows[i].y, rows[i].z, -Dot(rows[i], offset)};
  }
  if (!FitsFloat(a) || !FitsFloat(inverse)) return std::nullopt;
  return inverse;
}

}  // namespace candela
