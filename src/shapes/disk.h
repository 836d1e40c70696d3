#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// A flat disk around the origin in the plane z = 0, edge included, hit from both sides. Its normal
/// points to +z.
class Disk final : public Shape {
 public:
  explicit Disk(float radius) : radius_(radius) {}
  static std::shared_ptr<const Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override;
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  Vec3 FlatNormal() const override { return {0, 0, 1}; }
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  std::unique_ptr<const SurfaceSampler> MakeSampler(
      const Transform& world_from_object, const Transform& object_from_world) const override;
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  float radius_;
};

}  // namespace candela
