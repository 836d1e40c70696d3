#pragma once

#include <memory>
#include <vector>

#include "scene_spec/mesh_spec.h"
#include "shapes/mesh.h"
#include "shapes/shape.h"

namespace candela {

/// A mesh that has one shape at time 0 and another at time 1, of the same triangles: in between,
/// corners and their normals go straight from one to the other.
class DeformingMesh final : public Shape {
 public:
  /// Of meshes that `FindDifference` finds nothing about.
  DeformingMesh(std::shared_ptr<const MeshSpec> begin, std::shared_ptr<const MeshSpec> end);

  /// In words what keeps one mesh from becoming the other; null when nothing does.
  static const char* FindDifference(const MeshSpec& begin, const MeshSpec& end);

  bool IsMoving() const override { return true; }
  Bounds3 ObjectBounds() const override { return bounds_; }
  /// As `Mesh` has it, at the time of the ray.
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  Vec3 LiftOf(const HitRecord& hit, Vec3 p, float time, bool is_inside) const override;
  std::optional<TriangleInput> Triangles() const override;
  uint64_t PrimitiveCount() const override { return begin_.PrimitiveCount(); }
  uint64_t MemoryBytes() const override;

 private:
  MeshTriangle TriangleAt(uint32_t triangle, float time) const;

  std::shared_ptr<const MeshSpec> spec_;  ///< Of the begin; says which triangles there are.
  Mesh begin_, end_;
  std::vector<Vec3> positions_;  ///< Those of the begin, then those of the end.
  Bounds3 bounds_;
};

}  // namespace candela
