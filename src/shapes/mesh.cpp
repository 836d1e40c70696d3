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

std::vector<Bounds3> TriangleBounds(const MeshSpec& spec) {
  std::vector<Bounds3> boxes(spec.triangles.size());
  for (size_t i = 0; i < boxes.size(); ++i) {
    for (const uint32_t corner : spec.triangles[i]) boxes[i].Extend(spec.positions[corner]);
  }
  return boxes;
}

}  // namespace

std::unique_ptr<Shape> Mesh::Create(ParamReader* params, ShapeContext* context) {
  const std::string path = params->RequiredWord("obj_file");
  auto spec = path.empty() ? nullptr : context->find_mesh(path);
  return spec ? std::make_unique<Mesh>(std::move(spec)) : nullptr;
}

Mesh::Mesh(std::shared_ptr<const MeshSpec> spec)
    : spec_(std::move(spec)), bvh_(TriangleBounds(*spec_)) {
  PlaceTriangles();
  if (spec_->normal_corners.empty()) ComputeVertexNormals();
}

void Mesh::ComputeVertexNormals() {
  // In double: the cross products of small triangles have no digits left in single precision.
  std::vector<Vec3d> sums(spec_->positions.size());
  for (const auto& [a, b, c] : spec_->triangles) {
    const Vec3d n = TriangleCross(spec_->positions[a], spec_->positions[b], spec_->positions[c]);
    for (const uint32_t corner : {a, b, c}) sums[corner] += n;
  }
  vertex_normals_.reserve(sums.size());
  for (const Vec3d& sum : sums) vertex_normals_.push_back(UnitOrZero(sum));
}

Vec3 Mesh::CornerNormal(uint32_t triangle, size_t corner, Vec3 face_normal) const {
  Vec3 n;
  if (!vertex_normals_.empty()) {
    n = vertex_normals_[spec_->triangles[triangle][corner]];
  } else if (const uint32_t index = spec_->normal_corners[triangle][corner];
             index != MeshSpec::kNoNormal) {
    n = spec_->normals[index];
  }
  return n == Vec3() ? face_normal : n;
}

void Mesh::PlaceTriangles() {
  placed_.reserve(bvh_.Items().size());
  for (const uint32_t index : bvh_.Items()) {
    const auto& [a, b, c] = spec_->triangles[index];
    placed_.push_back({spec_->positions[a], spec_->positions[b], spec_->positions[c], index});
  }
}

bool Mesh::Intersect(const Ray& ray, HitRecord* hit) const {
  const ShearedRay sheared(ray);
  bool found = false;
  bvh_.TraversePlaces(ray, &hit->t, [&](uint32_t place) {
    const PlacedTriangle& triangle = placed_[place];
    const float t_limit = hit->t;
    // Of equal distances the smaller index counts, whatever the order of the tree.
    const bool wins_ties = found && triangle.index < hit->primitive;
    if (wins_ties) hit->t = std::nextafter(t_limit, Bounds3::kInfinity);
    if (IntersectTriangle(sheared, ray.t_min, triangle.a, triangle.b, triangle.c, hit)) {
      hit->primitive = triangle.index;
      found = true;
    } else if (wins_ties) {
      hit->t = t_limit;
    }
    return false;
  });
  return found;
}

bool Mesh::Occludes(const Ray& ray) const {
  const ShearedRay sheared(ray);
  HitRecord hit;
  hit.t = ray.t_max;
  bool found = false;
  bvh_.TraversePlaces(ray, &ray.t_max, [&](uint32_t place) {
    const PlacedTriangle& triangle = placed_[place];
    return found = IntersectTriangle(sheared, ray.t_min, triangle.a, triangle.b, triangle.c, &hit);
  });
  return found;
}

SurfacePoint Mesh::SurfaceAt(const Ray&, const HitRecord& hit) const {
  const auto& corners = spec_->triangles[hit.primitive];
  const Vec3 a = spec_->positions[corners[0]];
  const Vec3 b = spec_->positions[corners[1]];
  const Vec3 c = spec_->positions[corners[2]];
  const Vec3 face_normal = TriangleNormal(a, b, c);
  const Vec3 blended = CornerNormal(hit.primitive, 0, face_normal) * (1 - hit.u - hit.v) +
                       CornerNormal(hit.primitive, 1, face_normal) * hit.u +
                       CornerNormal(hit.primitive, 2, face_normal) * hit.v;
  return {TrianglePoint(a, b, c, hit.u, hit.v), TrianglePointError(a, b, c, hit.u, hit.v),
          face_normal, blended == Vec3() ? face_normal : blended};
}

uint64_t Mesh::MemoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return sizeof *this + bvh_.MemoryBytes() + bytes(placed_) + bytes(vertex_normals_) +
         bytes(spec_->positions) + bytes(spec_->normals) + bytes(spec_->triangles) +
         bytes(spec_->normal_corners);
}

}  // namespace candela
