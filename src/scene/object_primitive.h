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

}  // namespace candela
