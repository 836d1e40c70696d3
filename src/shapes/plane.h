#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// The infinite plane of the points p with Dot(normal, p) = offset, hit from both sides.
class Plane final : public Shape {
 public:
  /// `normal` has any length but 0; `offset` counts in units of that length.
  Plane(Vec3 normal, float offset);
  static std::shared_ptr<const Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override { return Bounds3::Infinite(); }
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  Vec3 FlatNormal() const override { return normal_; }
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  Vec3 normal_;  ///< Its largest component is between 1/2 and 1.
  float offset_;
};

}  // namespace candela
