#include "scene/scene.h"

#include <cmath>
#include <set>

#include "base/check.h"

namespace candela {

namespace {

/// Adds what a material with textures asks for, in object space.
void AddTextureSpace(const SceneObject& object, const HitRecord& hit, SurfacePoint* point) {
  object.shape->AddTextureCoordinates(hit, point);
  point->object_space = object.space.get();
}

/// Takes both normals of an object into the world.
void NormalsToWorld(const SceneObject& object, const Transform& object_from_world,
                    SurfacePoint* point) {
  if (object.HasFlatNormal()) {
    point->n_geometric = point->n_shading = object.flat_normal;
    return;
  }
  const bool is_flat = point->n_shading == point->n_geometric;
  point->n_geometric = SceneObject::NormalToWorld(point->n_geometric, object_from_world);
  point->n_shading = is_flat ? point->n_geometric
                             : SceneObject::NormalToWorld(point->n_shading, object_from_world);
}

/// Takes the point of an object as whitted sees it into the world, but for `p` itself.
void ToWorldForShading(const SceneObject& object, const Transform& object_from_world,
                       SurfacePoint* point) {
  if (object.is_textured) point->dpdu = point->dpdv = Vec3();
  if (object.is_textured || object.HasFlatNormal()) {
    NormalsToWorld(object, object_from_world, point);
  } else {
    point->n_shading = SceneObject::NormalToWorld(point->n_shading, object_from_world);
  }
}

/// Takes the point of an object into the world. In place: a copy of the whole would have to wait
/// for what has just been stored.
void ToWorld(const SceneObject& object, const Transform& world_from_object,
             const Transform& object_from_world, SurfacePoint* point) {
  const Vec3 p = world_from_object.Point(point->p);
  // A ray that leaves from here is taken back to object space, with a rounding error of its own.
  const Vec3 way_back = object_from_world.PointError(p, {});
  point->p_error = world_from_object.PointError(point->p, point->p_error + way_back);
  point->p = p;
  NormalsToWorld(object, object_from_world, point);
  if (object.is_textured) {
    point->dpdu = world_from_object.Vector(point->dpdu);
    point->dpdv = world_from_object.Vector(point->dpdv);
  }
}

/// Of an object that was hit, so that there are ways at that time.
MovingTransform::Pair WaysAt(const SceneObject& object, float time) {
  const auto ways = object.space->At(time);
  CHECK(ways);
  return *ways;
}

}  // namespace

// Each of these has one variable that it returns, which is made where the caller wants it.
SurfacePoint Scene::ShadingAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  return object.is_moving ? MovingShadingAt(object, ray, hit) : RestingShadingAt(object, ray, hit);
}

SurfacePoint Scene::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = objects_[hit.object];
  return object.is_moving ? MovingSurfaceAt(object, ray, hit) : RestingSurfaceAt(object, ray, hit);
}

SurfacePoint Scene::RestingShadingAt(const SceneObject& object, const Ray& ray,
                                     const HitRecord& hit) {
  SurfacePoint point = object.shape->SurfaceAt(object.ToObject(ray), hit);
  if (object.is_textured) AddTextureSpace(object, hit, &point);
  ToWorldForShading(object, object.object_from_world, &point);
  point.p = ray.At(hit.t);
  return point;
}

SurfacePoint Scene::MovingShadingAt(const SceneObject& object, const Ray& ray,
                                    const HitRecord& hit) {
  const Transform object_from_world = WaysAt(object, ray.time).object_from_world;
  SurfacePoint point = object.shape->SurfaceAt(SceneObject::ToObject(ray, object_from_world), hit);
  point.time = ray.time;
  if (object.is_textured) AddTextureSpace(object, hit, &point);
  ToWorldForShading(object, object_from_world, &point);
  point.p = ray.At(hit.t);
  return point;
}

SurfacePoint Scene::RestingSurfaceAt(const SceneObject& object, const Ray& ray,
                                     const HitRecord& hit) {
  SurfacePoint point = object.shape->SurfaceAt(object.ToObject(ray), hit);
  if (object.is_textured) AddTextureSpace(object, hit, &point);
  if (!object.is_baked) {
    ToWorld(object, object.world_from_object, object.object_from_world, &point);
  } else if (point.n_shading != point.n_geometric) {
    point.n_shading = NormalizeAnyLength(point.n_shading);
  }
  return point;
}

SurfacePoint Scene::MovingSurfaceAt(const SceneObject& object, const Ray& ray,
                                    const HitRecord& hit) {
  const auto [world_from_object, object_from_world] = WaysAt(object, ray.time);
  SurfacePoint point = object.shape->SurfaceAt(SceneObject::ToObject(ray, object_from_world), hit);
  point.time = ray.time;
  if (object.is_textured) AddTextureSpace(object, hit, &point);
  ToWorld(object, world_from_object, object_from_world, &point);
  return point;
}

Vec3 Scene::LiftOf(const HitRecord& hit, const SurfacePoint& point, bool is_inside) const {
  const SceneObject& object = objects_[hit.object];
  if (object.is_moving) {
    const auto [world_from_object, object_from_world] = WaysAt(object, point.time);
    const Vec3 local = object_from_world.Point(point.p);
    return world_from_object.Vector(object.shape->LiftOf(hit, local, point.time, is_inside));
  }
  const Vec3 local = object.object_from_world.Point(point.p);
  return object.world_from_object.Vector(object.shape->LiftOf(hit, local, point.time, is_inside));
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
  const SceneObject& object = objects_[hit.object];
  const Ray local_ray = object.is_moving
                            ? SceneObject::ToObject(ray, WaysAt(object, ray.time).object_from_world)
                            : object.ToObject(ray);
  SurfacePoint local = object.shape->SurfaceAt(local_ray, hit);
  local.time = ray.time;
  object.shape->AddTextureCoordinates(hit, &local);
  return local.uv;
}

Bounds3 Scene::Bounds() const {
  Bounds3 bounds;
  for (const SceneObject& object : objects_) {
    const Bounds3 box = object.WorldBounds();
    if (box.IsFinite()) bounds.Extend(box);
  }
  return bounds;
}

uint64_t Scene::MemoryBytes() const {
  uint64_t bytes = sizeof *this + tree_.MemoryBytes();
  std::set<const Shape*> counted;
  for (const SceneObject& object : objects_) {
    bytes += sizeof object + sizeof(SourceLocation);
    if (object.space) bytes += object.space->MemoryBytes();
    if (counted.insert(object.shape.get()).second) bytes += object.shape->MemoryBytes();
  }
  for (const auto& texture : textures_) bytes += texture->MemoryBytes();
  if (background_.cube_map) bytes += background_.cube_map->MemoryBytes();
  if (background_.environment) bytes += background_.environment->MemoryBytes();
  return bytes;
}

}  // namespace candela
