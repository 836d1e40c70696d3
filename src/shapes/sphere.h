#pragma once

#include <memory>

#include "scene_spec/param_reader.h"
#include "shapes/shape.h"

namespace candela {

struct ShapeContext;

/// A sphere around the origin. Its normal points outwards.
class Sphere final : public Shape {
 public:
  explicit Sphere(float radius) : radius_(radius) {}
  static std::shared_ptr<const Shape> Create(ParamReader* params, ShapeContext* context);

  Bounds3 ObjectBounds() const override;
  bool Intersect(const Ray& ray, HitRecord* hit) const override;
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const override;
  void AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const override;
  std::unique_ptr<const SurfaceSampler> MakeSampler(
      const Transform& world_from_object, const Transform& object_from_world) const override;
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  float radius_;
};

}  // namespace candela
