#include "shapes/deforming_mesh.h"

#include <utility>

#include "geometry/triangle.h"

namespace candela {
namespace {

/// As the kernel has it, so that points and hits agree.
Vec3 Between(Vec3 begin, Vec3 end, float time) {
  return begin * (1 - time) + end * time;
}

}  // namespace

DeformingMesh::DeformingMesh(std::shared_ptr<const MeshSpec> begin,
                             std::shared_ptr<const MeshSpec> end)
    : spec_(begin),
      begin_(std::move(begin), Mesh::FaceNormals::kKeep),
      end_(end, Mesh::FaceNormals::kKeep),
      positions_(spec_->positions) {
  positions_.insert(positions_.end(), end->positions.begin(), end->positions.end());
  bounds_ = begin_.ObjectBounds();
  bounds_.Extend(end_.ObjectBounds());
}

const char* DeformingMesh::FindDifference(const MeshSpec& begin, const MeshSpec& end) {
  if (begin.positions.size() != end.positions.size()) return "the numbers of vertices differ";
  if (begin.triangles != end.triangles) {
    return "cut into triangles, without those that have no area, they differ";
  }
  if (begin.normal_corners != end.normal_corners || begin.normals.size() != end.normals.size()) {
    return "their corners have different normals";
  }
  return nullptr;
}

MeshTriangle DeformingMesh::TriangleAt(uint32_t triangle, float time) const {
  MeshTriangle now = begin_.TriangleAt(triangle);
  const MeshTriangle end = end_.TriangleAt(triangle);
  for (size_t k = 0; k < 3; ++k) {
    now.p[k] = Between(now.p[k], end.p[k], time);
    now.n[k] = Between(now.n[k], end.n[k], time);
  }
  return now;
}

bool DeformingMesh::Intersect(const Ray& ray, HitRecord* hit) const {
  const ShearedRay sheared(ray);
  bool found = false;
  for (uint32_t i = 0; i < spec_->triangles.size(); ++i) {
    const auto [a, b, c] = TriangleAt(i, ray.time).p;
    if (!IntersectTriangle(sheared, ray.t_min, a, b, c, hit)) continue;
    hit->primitive = i;
    found = true;
  }
  return found;
}

SurfacePoint DeformingMesh::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  return TriangleAt(hit.primitive, ray.time).SurfaceAt(hit);
}

void DeformingMesh::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  TriangleAt(hit.primitive, point->time)
      .AddTextureCoordinates(begin_.UvsOf(hit.primitive), hit, point);
}

Vec3 DeformingMesh::LiftOf(const HitRecord& hit, Vec3 p, float time, bool is_inside) const {
  return TriangleAt(hit.primitive, time).LiftOf(hit, p, is_inside);
}

std::optional<TriangleInput> DeformingMesh::Triangles() const {
  return TriangleInput{positions_, spec_->triangles, 2};
}

uint64_t DeformingMesh::MemoryBytes() const {
  return begin_.MemoryBytes() + end_.MemoryBytes() + positions_.capacity() * sizeof(Vec3);
}

}  // namespace candela
