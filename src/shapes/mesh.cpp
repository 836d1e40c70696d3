#include "shapes/mesh.h"

#include <utility>

#include "geometry/triangle.h"
#include "shapes/shape_context.h"

namespace candela {
namespace {

Vec3 UnitOrZero(Vec3d v) {
  const double length = Length(v);
  return length > 0 ? ToFloat(v / length) : Vec3();
}

}  // namespace

std::shared_ptr<const Shape> Mesh::Create(ParamReader* params, ShapeContext* context) {
  const ParamWord path = params->RequiredPath("obj_file");
  auto spec = path.text.empty() ? nullptr : context->find_mesh(path);
  if (!spec) return nullptr;
  std::shared_ptr<const Shape>& mesh = (*context->made_of_meshes)[spec];
  if (!mesh) mesh = std::make_shared<Mesh>(std::move(spec));
  return mesh;
}

Mesh::Mesh(std::shared_ptr<const MeshSpec> spec)
    : spec_(std::move(spec)),
      positions_(spec_->positions),
      normals_(spec_->normals),
      normal_corners_(spec_->normal_corners) {
  if (spec_->normal_corners.empty()) ComputeVertexNormals();
  ComputeBounds();
}

void Mesh::ComputeBounds() {
  for (const Corners& corners : spec_->triangles) {
    for (const uint32_t corner : corners) bounds_.Extend(positions_[corner]);
  }
}

void Mesh::ComputeVertexNormals() {
  // In double: the cross products of small triangles have no digits left in single precision.
  std::vector<Vec3d> sums(positions_.size());
  for (const auto& [a, b, c] : spec_->triangles) {
    const Vec3d n = TriangleCross(positions_[a], positions_[b], positions_[c]);
    for (const uint32_t corner : {a, b, c}) sums[corner] += n;
  }
  own_normals_.reserve(sums.size());
  for (const Vec3d& sum : sums) own_normals_.push_back(UnitOrZero(sum));
  normals_ = own_normals_;
  normal_corners_ = spec_->triangles;
}

bool Mesh::HasNormal(size_t triangle, size_t corner) const {
  const uint32_t index = normal_corners_[triangle][corner];
  return index != MeshSpec::kNoNormal && normals_[index] != Vec3();
}

Vec3 Mesh::CornerNormal(size_t triangle, size_t corner, Vec3 face_normal) const {
  return HasNormal(triangle, corner) ? normals_[normal_corners_[triangle][corner]] : face_normal;
}

Vec3 Mesh::FaceNormal(size_t triangle) const {
  const auto& [a, b, c] = spec_->triangles[triangle];
  const Vec3 n = TriangleNormal(positions_[a], positions_[b], positions_[c]);
  return is_mirrored_ ? -n : n;
}

bool Mesh::Intersect(const Ray& ray, HitRecord* hit) const {
  const ShearedRay sheared(ray);
  bool found = false;
  for (uint32_t i = 0; i < spec_->triangles.size(); ++i) {
    const auto& [a, b, c] = spec_->triangles[i];
    if (!IntersectTriangle(sheared, ray.t_min, positions_[a], positions_[b], positions_[c], hit)) {
      continue;
    }
    hit->primitive = i;
    found = true;
  }
  return found;
}

SurfacePoint Mesh::SurfaceAt(const Ray&, const HitRecord& hit) const {
  const auto& corners = spec_->triangles[hit.primitive];
  const Vec3 a = positions_[corners[0]];
  const Vec3 b = positions_[corners[1]];
  const Vec3 c = positions_[corners[2]];
  const Vec3 face_normal = FaceNormal(hit.primitive);
  const Vec3 blended = CornerNormal(hit.primitive, 0, face_normal) * (1 - hit.u - hit.v) +
                       CornerNormal(hit.primitive, 1, face_normal) * hit.u +
                       CornerNormal(hit.primitive, 2, face_normal) * hit.v;
  return {TrianglePoint(a, b, c, hit.u, hit.v), TrianglePointError(a, b, c, hit.u, hit.v),
          face_normal, blended == Vec3() ? face_normal : blended};
}

// Hanika, "Hacking the Shadow Terminator" (in "Ray Tracing Gems II", 2021): the mean of the point
// as it lies in the tangential planes of the corners. Only where it lies below all of them:
// elsewhere the normals lean without that the surface were round. And only where they lean by less
// than 45 degrees: more is an edge that is smoothed over, as of a cube, from whose sides points
// would be lifted into what the cube stands on.
Vec3 Mesh::LiftOf(const HitRecord& hit, Vec3 p, bool is_inside) const {
  const auto& corners = spec_->triangles[hit.primitive];
  const float weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
  const float side = is_inside ? -1.0f : 1.0f;
  const Vec3 a = positions_[corners[0]], b = positions_[corners[1]], c = positions_[corners[2]];
  const Vec3 area = Cross(b - a, c - a);
  const float half_squared = LengthSquared(area) / 2;
  Vec3 lift{};
  for (size_t k = 0; k < 3; ++k) {
    if (!HasNormal(hit.primitive, k)) return {};
    const Vec3 n = NormalizeAnyLength(normals_[normal_corners_[hit.primitive][k]]) * side;
    const float height = Dot(p - positions_[corners[k]], n), leaning = Dot(n, area);
    if (!(height <= 0) || !(leaning * leaning > half_squared)) return {};
    lift += n * (-height * weights[k]);
  }
  return lift;
}

std::optional<TriangleInput> Mesh::Triangles() const {
  return TriangleInput{positions_, spec_->triangles};
}

uint64_t Mesh::MemoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return sizeof *this + bytes(own_positions_) + bytes(own_normals_) + bytes(own_normal_corners_) +
         bytes(spec_->positions) + bytes(spec_->normals) + bytes(spec_->triangles) +
         bytes(spec_->normal_corners) + bytes(spec_->uvs) + bytes(spec_->uv_corners);
}

// Over a triangle the position is linear in the coordinates: its edges are those of the coordinates
// times the derivatives, which is solved for these.
void Mesh::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  const auto& [ia, ib, ic] = spec_->triangles[hit.primitive];
  const Vec3 ab = positions_[ib] - positions_[ia], ac = positions_[ic] - positions_[ia];
  Vec2 a{0, 0}, b{1, 0}, c{0, 1};
  if (!spec_->uv_corners.empty()) {
    const auto& [ta, tb, tc] = spec_->uv_corners[hit.primitive];
    if (ta != MeshSpec::kNoUv && tb != MeshSpec::kNoUv && tc != MeshSpec::kNoUv) {
      a = spec_->uvs[ta];
      b = spec_->uvs[tb];
      c = spec_->uvs[tc];
    }
  }
  point->uv = a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v;
  const Vec2 b_a = b - a, c_a = c - a;
  const float area = b_a.x * c_a.y - b_a.y * c_a.x;
  if (area == 0) return;  // All corners lie on a line of the texture.
  point->dpdu = (ab * c_a.y - ac * b_a.y) * (1 / area);
  point->dpdv = (ac * b_a.x - ab * c_a.x) * (1 / area);
}

}  // namespace candela
