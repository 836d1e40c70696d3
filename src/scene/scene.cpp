#include "scene/scene.h"

#include <cmath>
#include <set>

namespace candela {

Vec3 Scene::NormalToWorld(uint32_t object, Vec3 n) const {
  // Normals go by the inverse transpose.
  return NormalizeAnyLength(objects_[object].object_from_world.TransposedVector(n));
}

SurfacePoint Scene::ShadingAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  SurfacePoint point;
  point.p = ray.At(hit.t);
  SurfacePoint local = object.shape->SurfaceAt(object.ToObject(ray), hit);
  point.n_shading = NormalToWorld(hit.object, local.n_shading);
  if (object.is_textured) {
    object.shape->AddTextureCoordinates(hit, &local);
    point.uv = local.uv;
  }
  return point;
}

SurfacePoint Scene::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  SurfacePoint local = object.shape->SurfaceAt(object.ToObject(ray), hit);
  if (object.is_textured) object.shape->AddTextureCoordinates(hit, &local);
  if (object.is_baked) {
    if (local.n_shading != local.n_geometric) local.n_shading = NormalizeAnyLength(local.n_shading);
    return local;
  }
  SurfacePoint world = local;
  world.p = object.world_from_object.Point(local.p);
  // A ray that leaves from here is taken back to object space, with a rounding error of its own.
  const Vec3 way_back = object.object_from_world.PointError(world.p, {});
  world.p_error = object.world_from_object.PointError(local.p, local.p_error + way_back);
  world.n_geometric = NormalToWorld(hit.object, local.n_geometric);
  const bool is_same = local.n_shading == local.n_geometric;
  world.n_shading = is_same ? world.n_geometric : NormalToWorld(hit.object, local.n_shading);
  if (object.is_textured) {
    world.dpdu = object.world_from_object.Vector(local.dpdu);
    world.dpdv = object.world_from_object.Vector(local.dpdv);
  }
  return world;
}

Vec3 Scene::LiftOf(const HitRecord& hit, const SurfacePoint& point, bool is_inside) const {
  const SceneObject& object = objects_[hit.object];
  const Vec3 local = object.object_from_world.Point(point.p);
  return object.world_from_object.Vector(object.shape->LiftOf(hit, local, is_inside));
}

float Scene::Transparency(Ray ray) const {
  ray.mask = kHoleRay;
  float left = 1;
  while (left > 0) {
    HitRecord hit;
    hit.t = ray.t_max;
    if (!Intersect(ray, &hit)) break;
    left *= material(hit).Transparency(SurfaceAt(ray, hit));
    ray.t_min = std::nextafter(hit.t, ray.t_max);
  }
  return left;
}

Vec2 Scene::TextureCoordinatesAt(const Ray& ray, const HitRecord& hit) const {
  const Shape& shape = *objects_[hit.object].shape;
  SurfacePoint local = shape.SurfaceAt(objects_[hit.object].ToObject(ray), hit);
  shape.AddTextureCoordinates(hit, &local);
  return local.uv;
}

Bounds3 Scene::Bounds() const {
  Bounds3 bounds;
  for (const SceneObject& object : objects_) {
    const Bounds3 box = TransformBounds(object.world_from_object, object.shape->ObjectBounds());
    if (box.IsFinite()) bounds.Extend(box);
  }
  return bounds;
}

uint64_t Scene::MemoryBytes() const {
  uint64_t bytes = sizeof *this + tree_.MemoryBytes();
  std::set<const Shape*> counted;
  for (const SceneObject& object : objects_) {
    bytes += sizeof object + sizeof(SourceLocation);
    if (counted.insert(object.shape.get()).second) bytes += object.shape->MemoryBytes();
  }
  for (const auto& texture : textures_) bytes += texture->MemoryBytes();
  if (background_.cube_map) bytes += background_.cube_map->MemoryBytes();
  if (background_.environment) bytes += background_.environment->MemoryBytes();
  return bytes;
}

}  // namespace candela
