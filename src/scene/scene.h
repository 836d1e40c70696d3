#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/source_location.h"
#include "cameras/camera.h"
#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "geometry/surface_point.h"
#include "kernel/group.h"
#include "lights/light.h"
#include "materials/material.h"
#include "scene/background.h"
#include "scene/fog.h"
#include "scene/interior.h"
#include "scene/scene_object.h"
#include "scene/scene_tree.h"
#include "textures/texture.h"

namespace candela {

/// A compiled scene: what integrators see. Immutable; all calls may be made concurrently.
class Scene {
 public:
  /// Looks for the nearest hit with `ray.t_min <= t < hit->t`; of equal t the object that comes
  /// first in the scene file, and in it the smallest primitive. A ray misses when it has a NaN, an
  /// infinite origin, or a direction whose squared length is 0 or infinite. False when nothing is
  /// hit; `*hit` is then as it was.
  bool Intersect(const Ray& ray, HitRecord* hit) const { return tree_.group->Intersect(ray, hit); }

  /// Whether anything lies in `ray.t_min <= t < ray.t_max`.
  bool Occluded(const Ray& ray) const { return tree_.group->Occluded(ray); }

  /// The same for many rays; see `Group`. The spans are equally long.
  void Intersect(RayOrder order, std::span<const Ray> rays, std::span<HitRecord> hits) const {
    tree_.Intersect(order, rays, hits);
  }
  void Occluded(RayOrder order, std::span<const Ray> rays, std::span<uint8_t> occluded) const {
    tree_.Occluded(order, rays, occluded);
  }

  /// Whether surfaces of some objects have holes. Rays of the kind `kShadowRay` pass those objects.
  bool HasHoles() const { return has_holes_; }
  /// Whether there are media that refract light by its wavelength.
  bool HasDispersion() const { return has_dispersion_; }

  /// What all objects leave of the light in `ray.t_min <= t < ray.t_max`: the product of the shares
  /// of their surfaces where nothing is, which is 0 when one has no holes. One hit after the other:
  /// to be asked where `Occluded` has found nothing.
  float Transparency(Ray ray) const;

  /// The hit point in world space, with unit normals; with texture coordinates where the material
  /// asks for them.
  SurfacePoint SurfaceAt(const Ray& ray, const HitRecord& hit) const;

  /// From the point of a hit to the round surface that the shading normals of its mesh pretend, on
  /// the inside or on the outside; 0 where it does not bulge there, and where an edge is smoothed
  /// over. Rays that start from it are not stopped by the flat triangles around.
  Vec3 LiftOf(const HitRecord& hit, const SurfacePoint& point, bool is_inside) const;

  /// The hit as the course sees it, at a third of the cost: the point o + t d, the shading normal,
  /// and, for materials that ask for texture coordinates, those and the geometric normal. The rest
  /// means nothing, so no ray can be spawned from it.
  SurfacePoint ShadingAt(const Ray& ray, const HitRecord& hit) const;

  /// The texture coordinates of a hit, whether or not the material asks for them.
  Vec2 TextureCoordinatesAt(const Ray& ray, const HitRecord& hit) const;

  const Camera& camera() const { return *camera_; }
  const Background& background() const { return background_; }
  /// Nothing where the air is clear. Only the integrator `whitted` knows fog.
  const std::optional<Fog>& fog() const { return fog_; }
  const std::vector<SceneObject>& objects() const { return objects_; }
  /// In the order of the scene file, the ones of area included.
  const std::vector<std::unique_ptr<const Light>>& lights() const { return lights_; }
  /// What each of them is called in the registry of lights.
  const std::vector<std::string>& light_types() const { return light_types_; }
  /// The names of the groups that lights and the background are in, each once.
  const std::vector<std::string>& light_groups() const { return light_groups_; }
  /// The places in it of a light's and of the background's.
  uint32_t GroupOfLight(size_t index) const { return group_of_light_[index]; }
  uint32_t GroupOfBackground() const { return group_of_background_; }
  const Material& material(const HitRecord& hit) const {
    return *materials_[objects_[hit.object].material];
  }
  const std::vector<std::unique_ptr<const Material>>& materials() const { return materials_; }
  /// What objects are filled with: different ones, each for any number of objects.
  const std::vector<Interior>& interiors() const { return interiors_; }
  /// Where the scene file describes a material, for messages.
  const SourceLocation& PlaceOfMaterial(size_t index) const { return material_places_[index]; }
  /// The same of the fog.
  const SourceLocation& PlaceOfFog() const { return fog_place_; }
  /// The same of an object.
  const SourceLocation& PlaceOfObject(size_t index) const { return object_places_[index]; }
  /// The same of a light.
  const SourceLocation& PlaceOfLight(size_t index) const { return light_places_[index]; }

  /// Whether the answers to rays depend on their times: something moves while the shutter is open.
  /// The camera may do so as well.
  bool IsMoving() const { return is_moving_; }

  /// The box around all bounded objects, wherever they come to be.
  Bounds3 Bounds() const;
  /// What finds the hits.
  const SceneTree& tree() const { return tree_; }
  /// What objects share counts once.
  uint64_t MemoryBytes() const;

 private:
  friend class SceneCompiler;
  Scene() = default;

  // Of objects that rest, and that move.
  static SurfacePoint RestingShadingAt(const SceneObject& object, const Ray& ray,
                                       const HitRecord& hit);
  static SurfacePoint RestingSurfaceAt(const SceneObject& object, const Ray& ray,
                                       const HitRecord& hit);
  static SurfacePoint MovingShadingAt(const SceneObject& object, const Ray& ray,
                                      const HitRecord& hit);
  static SurfacePoint MovingSurfaceAt(const SceneObject& object, const Ray& ray,
                                      const HitRecord& hit);

  std::unique_ptr<const Camera> camera_;
  Background background_;
  std::vector<SceneObject> objects_;
  std::vector<std::unique_ptr<const Light>> lights_;
  std::vector<std::string> light_types_;
  std::vector<SourceLocation> light_places_;
  std::vector<std::string> light_groups_;
  std::vector<uint32_t> group_of_light_;
  uint32_t group_of_background_ = 0;
  std::vector<std::unique_ptr<const Material>> materials_;
  std::vector<SourceLocation> material_places_;
  std::vector<SourceLocation> object_places_;
  std::vector<std::shared_ptr<const Texture>> textures_;
  std::vector<Interior> interiors_;
  SceneTree tree_;
  bool has_holes_ = false;
  bool has_dispersion_ = false;
  bool is_moving_ = false;
  std::optional<Fog> fog_;
  SourceLocation fog_place_;
};

}  // namespace candela
