#pragma once

#include <memory>
#include <vector>

#include "kernel/bvh.h"
#include "scene_spec/mesh_spec.h"
#include "scene_spec/param_reader.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// A triangle mesh with a normal at each corner, blended across the faces. Where the file gives
/// none, a vertex has the normalised sum of its faces' cross products, so that large faces count
/// more; vertices at the same place with different indices stay apart.
class Mesh final : public Shape {
 public:
  explicit Mesh(std::shared_ptr<const MeshSpec> spec);
  /// Null when its file could not be loaded.
  static std::unique_ptr<Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override { return bvh_.Bounds(); }
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  bool Occludes(const Ray& ray) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  uint64_t PrimitiveCount() const override { return spec_->triangles.size(); }
  uint64_t MemoryBytes() const override;

 private:
  /// The corners of a triangle and its index in the file, in one place for the search.
  struct PlacedTriangle {
    Vec3 a, b, c;
    uint32_t index;
  };

  void PlaceTriangles();
  void ComputeVertexNormals();
  Vec3 CornerNormal(uint32_t triangle, size_t corner, Vec3 face_normal) const;

  std::shared_ptr<const MeshSpec> spec_;
  std::vector<Vec3>
      vertex_normals_;  ///< Unit or 0, by position index; empty when the file has its own.
  Bvh bvh_;
  std::vector<PlacedTriangle> placed_;  ///< In the order of the tree's leaves.
};

}  // namespace candela
