#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "geometry/ray.h"
#include "math/moving_transform.h"
#include "shapes/shape.h"

namespace candela {

/// A shape with its place in the world and what it is made of.
struct SceneObject {
  static constexpr uint32_t kNoLight = 0xFFFFFFFF;
  static constexpr uint32_t kNoInterior = 0xFFFFFFFF;

  std::shared_ptr<const Shape> shape;  ///< Objects of the same mesh share it.
  /// The identity for triangles that are baked: they lie in the world, for nobody else.
  /// Of what moves, those of time 0.
  Transform world_from_object, object_from_world;
  uint32_t material = 0;
  uint32_t light = kNoLight;        ///< The area light whose surface this is.
  bool is_instance = false;         ///< Its triangles have a tree of their own, which it shares.
  std::string type;                 ///< As in the registry of shapes.
  std::string description;          ///< For people: type and line, with the file if another.
  bool is_textured = false;         ///< The material asks for texture coordinates.
  uint32_t interior = kNoInterior;  ///< What light gets into, in the scene's list.
  bool has_holes = false;           ///< The material lets light through as if nothing were there.
  bool is_baked = false;            ///< It consists of triangles that lie in the world.
  /// It depends on the time: its place, which then `space` says, or its shape.
  bool is_moving = false;
  /// The unit normal of a flat object at rest, in the world; 0 of all others.
  Vec3 flat_normal{};
  /// Where it is when it moves. Also of what is baked: where its texture fills space, for materials
  /// that ask for coordinates.
  std::unique_ptr<const MovingTransform> space{};

  /// The ray as the shape gets it for `Intersect` and `SurfaceAt`. Where it ends says the record of
  /// the hit, and whom it sees has been decided; leaving that out saves copies that would have to
  /// wait for what has just been stored.
  Ray ToObject(const Ray& ray) const { return ToObject(ray, object_from_world); }
  static Ray ToObject(const Ray& ray, const Transform& object_from_world) {
    Ray local(object_from_world.Point(ray.origin), object_from_world.Vector(ray.direction));
    local.t_min = ray.t_min;
    local.time = ray.time;
    return local;
  }

  /// Whether that is known.
  bool HasFlatNormal() const { return flat_normal != Vec3(); }

  /// A unit normal of the shape in world space, as unit vector: by the inverse transpose.
  Vec3 NormalToWorld(Vec3 n) const { return NormalToWorld(n, object_from_world); }
  static Vec3 NormalToWorld(Vec3 n, const Transform& object_from_world) {
    return NormalizeAnyLength(object_from_world.TransposedVector(n));
  }

  /// A box around all places where it comes to be.
  Bounds3 WorldBounds() const;
};

}  // namespace candela
