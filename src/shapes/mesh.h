#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "scene_spec/mesh_spec.h"
#include "scene_spec/param_reader.h"
#include "shapes/mesh_triangle.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// A triangle mesh with a normal at each corner, blended across the faces. Where the file gives
/// none, a vertex has the normalised sum of its faces' cross products, so that large faces count
/// more; vertices at the same place with different indices stay apart.
class Mesh final : public Shape {
 public:
  /// What happens to normals of a file that only say that the face is flat.
  enum class FaceNormals {
    kLeaveOut,  ///< Where most faces are flat: what has none is flat to the last bit.
    kKeep,      ///< For meshes between which others are blended.
  };

  explicit Mesh(std::shared_ptr<const MeshSpec> spec,
                FaceNormals face_normals = FaceNormals::kLeaveOut);
  Mesh(const Mesh&) = delete;  // Its spans would refer to the other one.
  Mesh& operator=(const Mesh&) = delete;
  /// Null when its file could not be loaded. Objects of the same file get the same mesh. With a
  /// second file it is a `DeformingMesh`.
  static std::shared_ptr<const Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override { return bounds_; }
  /// The plain definition of a hit: every triangle is tested, one after the other. For tests and
  /// meshes of a few triangles; a scene finds hits by way of `Triangles`.
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  Vec3 LiftOf(const HitRecord& hit, Vec3 p, float time, bool is_inside) const override;
  std::optional<TriangleInput> Triangles() const override;
  std::unique_ptr<const SurfaceSampler> MakeSampler(
      const Transform& world_from_object, const Transform& object_from_world) const override;
  std::shared_ptr<const Shape> Baked(const Mat4& world_from_object) const override;
  uint64_t PrimitiveCount() const override { return spec_->triangles.size(); }
  uint64_t MemoryBytes() const override;

  /// One of its triangles, and the texture coordinates of its corners.
  MeshTriangle TriangleAt(uint32_t triangle) const;
  std::array<Vec2, 3> UvsOf(uint32_t triangle) const;

 private:
  using Corners = MeshSpec::Corners;

  Mesh() = default;

  void ComputeBounds();
  void ComputeVertexNormals();
  void LeaveOutFaceNormals();
  bool HasFaceNormal(size_t triangle) const;
  void BakeNormals(const Mat4& object_from_world, Mesh* baked) const;
  bool HasNormal(size_t triangle, size_t corner) const;
  Vec3 FaceNormal(size_t triangle) const;

  std::shared_ptr<const MeshSpec> spec_;  ///< As it was read; says which triangles there are.
  std::span<const Vec3> positions_;
  std::span<const Vec3> normals_;            ///< A corner has that of its index,
  std::span<const Corners> normal_corners_;  ///< unless that is 0 or kNoNormal: then the face's.
  /// Baking has turned the surface inside out: face normals point to where corners are clockwise.
  bool is_mirrored_ = false;
  Bounds3 bounds_;

  // What the spans above refer to where it is not a part of the spec.
  std::vector<Vec3> own_positions_, own_normals_;
  std::shared_ptr<const std::vector<Corners>> own_normal_corners_;  ///< Baked meshes share them.
};

}  // namespace candela
