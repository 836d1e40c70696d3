#include "scene/scene.h"

#include <cmath>
#include <set>

namespace candela {

SurfacePoint Scene::ShadingAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  SurfacePoint point = object.shape->SurfaceAt(object.ToObject(ray), hit);
  if (object.is_textured) {
    object.shape->AddTextureCoordinates(hit, &point);
    point.dpdu = point.dpdv = Vec3();
    point.n_geometric = object.NormalToWorld(point.n_geometric);
    point.object_from_world = &object.node_from_world;
  }
  point.p = ray.At(hit.t);
  point.n_shading = object.NormalToWorld(point.n_shading);
  return point;
}

SurfacePoint Scene::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  SurfacePoint point = object.shape->SurfaceAt(object.ToObject(ray), hit);
  if (object.is_textured) {
    object.shape->AddTextureCoordinates(hit, &point);
    point.object_from_world = &object.node_from_world;
  }
  const bool is_flat = point.n_shading == point.n_geometric;
  if (object.is_baked) {
    if (!is_flat) point.n_shading = NormalizeAnyLength(point.n_shading);
    return point;
  }
  // In place: a copy of the whole would have to wait for what has just been stored.
  const Vec3 p = object.world_from_object.Point(point.p);
  // A ray that leaves from here is taken back to object space, with a rounding error of its own.
  const Vec3 way_back = object.object_from_world.PointError(p, {});
  point.p_error = object.world_from_object.PointError(point.p, point.p_error + way_back);
  point.p = p;
  point.n_geometric = object.NormalToWorld(point.n_geometric);
  point.n_shading = is_flat ? point.n_geometric : object.NormalToWorld(point.n_shading);
  if (object.is_textured) {
    point.dpdu = object.world_from_object.Vector(point.dpdu);
    point.dpdv = object.world_from_object.Vector(point.dpdv);
  }
  return point;
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
