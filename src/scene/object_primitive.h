#pragma once

#include "kernel/primitive_set.h"
#include "scene/scene_object.h"

namespace candela {

/// An object with a formula of its own, as the search sees it: one primitive in world space.
class ObjectPrimitive final : public PrimitiveSet {
 public:
  /// The object has to outlive it, where it is.
  explicit ObjectPrimitive(const SceneObject& object) : object_(object) {}

  Bounds3 PrimitiveBounds(uint32_t, uint32_t) const override {
    return TransformBounds(object_.world_from_object, object_.shape->ObjectBounds());
  }
  bool IntersectPrimitive(const Ray& ray, uint32_t, HitRecord* hit) const override {
    return object_.shape->Intersect(object_.ToObject(ray), hit);
  }

 private:
  const SceneObject& object_;
};

/// The same for one that moves.
class MovingObjectPrimitive final : public PrimitiveSet {
 public:
  explicit MovingObjectPrimitive(const SceneObject& object) : object_(object) {}

  uint32_t TimeSteps() const override {
    return static_cast<uint32_t>(object_.space->steps().size());
  }
  Bounds3 PrimitiveBounds(uint32_t, uint32_t step) const override {
    return TransformBounds(Transform(object_.space->steps()[step]), object_.shape->ObjectBounds());
  }
  bool IntersectPrimitive(const Ray& ray, uint32_t, HitRecord* hit) const override {
    const auto ways = object_.space->At(ray.time);
    return ways &&
           object_.shape->Intersect(SceneObject::ToObject(ray, ways->object_from_world), hit);
  }

 private:
  const SceneObject& object_;
};

}  // namespace candela
