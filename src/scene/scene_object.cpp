#include "scene/scene_object.h"

namespace candela {

Bounds3 SceneObject::WorldBounds() const {
  const Bounds3 at_begin = TransformBounds(world_from_object, shape->ObjectBounds());
  if (!is_moving) return at_begin;
  Bounds3 bounds;
  for (const Mat4& step : space->steps()) {
    bounds.Extend(TransformBounds(Transform(step), shape->ObjectBounds()));
  }
  return bounds;
}

}  // namespace candela
