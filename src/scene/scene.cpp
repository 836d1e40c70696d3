#include "scene/scene.h"

#include <cmath>

namespace candela {
namespace {

/// A ray without a direction has no hits; comparisons alone would not always see that, and with a
/// NaN every box of the tree would be visited.
bool IsTraceable(const Ray& ray) {
  const float length = LengthSquared(ray.direction);
  return length > 0 && std::isfinite(length) && IsFinite(ray.origin);
}

}  // namespace

Ray Scene::ToObject(uint32_t object, const Ray& ray) const {
  const Transform& object_from_world = objects_[object].object_from_world;
  Ray local = ray;
  local.origin = object_from_world.Point(ray.origin);
  local.direction = object_from_world.Vector(ray.direction);
  return local;
}

bool Scene::IntersectObject(uint32_t object, const Ray& ray, HitRecord* hit) const {
  const float t_limit = hit->t;
  // Of equal distances the earlier object counts, whatever the order of the tree.
  if (object < hit->object && hit->IsHit()) hit->t = std::nextafter(t_limit, Bounds3::kInfinity);
  if (!objects_[object].shape->Intersect(ToObject(object, ray), hit)) {
    hit->t = t_limit;
    return false;
  }
  hit->object = object;
  return true;
}

bool Scene::Intersect(const Ray& ray, HitRecord* hit) const {
  if (!IsTraceable(ray)) return false;
  bool found = false;
  for (const uint32_t object : unbounded_) found |= IntersectObject(object, ray, hit);
  bvh_.Traverse(ray, &hit->t, [&](uint32_t object) {
    found |= IntersectObject(object, ray, hit);
    return false;
  });
  return found;
}

bool Scene::IsOccludedBy(uint32_t object, const Ray& ray) const {
  return objects_[object].shape->Occludes(ToObject(object, ray));
}

bool Scene::Occluded(const Ray& ray) const {
  if (!IsTraceable(ray)) return false;
  for (const uint32_t object : unbounded_) {
    if (IsOccludedBy(object, ray)) return true;
  }
  bool found = false;
  bvh_.Traverse(ray, &ray.t_max,
                [&](uint32_t object) { return found = IsOccludedBy(object, ray); });
  return found;
}

Vec3 Scene::NormalToWorld(uint32_t object, Vec3 n) const {
  // Normals go by the inverse transpose.
  return NormalizeAnyLength(objects_[object].object_from_world.TransposedVector(n));
}

SurfacePoint Scene::ShadingAt(const Ray& ray, const HitRecord& hit) const {
  const Shape& shape = *objects_[hit.object].shape;
  SurfacePoint point;
  point.p = ray.At(hit.t);
  point.n_shading =
      NormalToWorld(hit.object, shape.SurfaceAt(ToObject(hit.object, ray), hit).n_shading);
  return point;
}

SurfacePoint Scene::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  const SurfacePoint local = object.shape->SurfaceAt(ToObject(hit.object, ray), hit);
  SurfacePoint world = local;
  world.p = object.world_from_object.Point(local.p);
  // A ray that leaves from here is taken back to object space, with a rounding error of its own.
  const Vec3 way_back = object.object_from_world.PointError(world.p, {});
  world.p_error = object.world_from_object.PointError(local.p, local.p_error + way_back);
  world.n_geometric = NormalToWorld(hit.object, local.n_geometric);
  world.n_shading = NormalToWorld(hit.object, local.n_shading);
  return world;
}

uint64_t Scene::MemoryBytes() const {
  uint64_t bytes = sizeof *this + bvh_.MemoryBytes();
  for (const SceneObject& object : objects_) bytes += sizeof object + object.shape->MemoryBytes();
  if (background_.cube_map) bytes += background_.cube_map->MemoryBytes();
  return bytes;
}

}  // namespace candela
