#pragma once

#include <array>
#include <memory>

#include "geometry/triangle.h"
#include "scene_spec/param_reader.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// A flat triangle, edges included, hit from both sides. Its normal points to where its corners are
/// seen counter-clockwise.
class Triangle final : public Shape {
 public:
  Triangle(Vec3 a, Vec3 b, Vec3 c) : corners_{a, b, c}, normal_(TriangleNormal(a, b, c)) {}
  /// Null, with a warning, for a triangle without area.
  static std::shared_ptr<const Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override;
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  Vec3 FlatNormal() const override { return normal_; }
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  std::unique_ptr<const SurfaceSampler> MakeSampler(
      const Transform& world_from_object, const Transform& object_from_world) const override;
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  std::array<Vec3, 3> corners_;
  Vec3 normal_;  ///< Of unit length; 0 without area.
};

}  // namespace candela
