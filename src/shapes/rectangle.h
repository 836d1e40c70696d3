#pragma once

#include <array>
#include <memory>

#include "scene_spec/param_reader.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// A flat rectangle around the origin in the plane z = 0, edges included, hit from both sides. Its
/// sides are parallel to x and y, its normal points to +z. It consists of two triangles, so that a
/// scene finds it as fast as them, and without gaps between rectangles that share their corners.
class Rectangle final : public Shape {
 public:
  /// Full lengths of the sides along x and y.
  Rectangle(float width, float height);
  static std::shared_ptr<const Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override;
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  std::optional<TriangleInput> Triangles() const override;
  /// A parallelogram, in general.
  std::shared_ptr<const Shape> Baked(const Mat4& world_from_object) const override;
  std::unique_ptr<const SurfaceSampler> MakeSampler(
      const Transform& world_from_object, const Transform& object_from_world) const override;
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  Rectangle() = default;

  Vec3 SideX() const { return corners_[1] - corners_[0]; }
  Vec3 SideY() const { return corners_[3] - corners_[0]; }

  std::array<Vec3, 4> corners_;  ///< One after the other; the first side is the one along x.
  Vec3 normal_;                  ///< Of unit length.
};

}  // namespace candela
