#include "shapes/mesh_triangle.h"

namespace candela {

// Hanika, "Hacking the Shadow Terminator" (in "Ray Tracing Gems II", 2021): the mean of the point
// as it lies in the tangential planes of the corners. Only where it lies below all of them:
// elsewhere the normals lean without that the surface were round. And only where they lean by less
// than 45 degrees: more is an edge that is smoothed over, as of a cube, from whose sides points
// would be lifted into what the cube stands on.
Vec3 MeshTriangle::LiftOf(const HitRecord& hit, Vec3 point, bool is_inside) const {
  const float weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
  const float side = is_inside ? -1.0f : 1.0f;
  const Vec3 area = Cross(p[1] - p[0], p[2] - p[0]);
  const float half_squared = LengthSquared(area) / 2;
  Vec3 lift{};
  for (size_t k = 0; k < 3; ++k) {
    if (n[k] == Vec3()) return {};
    const Vec3 unit = NormalizeAnyLength(n[k]) * side;
    const float height = Dot(point - p[k], unit), leaning = Dot(unit, area);
    if (!(height <= 0) || !(leaning * leaning > half_squared)) return {};
    lift += unit * (-height * weights[k]);
  }
  return lift;
}

// Over a triangle the position is linear in the coordinates: its edges are those of the coordinates
// times the derivatives, which is solved for these.
void MeshTriangle::AddTextureCoordinates(const std::array<Vec2, 3>& uvs, const HitRecord& hit,
                                         SurfacePoint* point) const {
  const auto [a, b, c] = uvs;
  const Vec3 ab = p[1] - p[0], ac = p[2] - p[0];
  point->uv = a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v;
  const Vec2 b_a = b - a, c_a = c - a;
  const float area = b_a.x * c_a.y - b_a.y * c_a.x;
  if (area == 0) return;  // All corners lie on a line of the texture.
  point->dpdu = (ab * c_a.y - ac * b_a.y) * (1 / area);
  point->dpdv = (ac * b_a.x - ab * c_a.x) * (1 / area);
}

}  // namespace candela
