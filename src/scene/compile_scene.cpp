#include "scene/compile_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "cameras/registry.h"
#include "lights/directional_light.h"
#include "lights/registry.h"
#include "math/elementary.h"
#include "scene/compile_interiors.h"
#include "scene/compile_materials.h"
#include "scene/node_places.h"
#include "scene/resolved_params.h"
#include "shapes/registry.h"
#include "textures/daylight_map.h"

namespace candela {

/// Holds what is known while a scene is compiled.
class SceneCompiler {
 public:
  /// So many triangles are copied for each object rather than shared, all copies together.
  static constexpr uint64_t kFewTriangles = 1000;

  SceneCompiler(const SceneSpec& spec, Diagnostics* diagnostics, const CompileOptions& options)
      : spec_(spec),
        diagnostics_(*diagnostics),
        accelerator_(options.accelerator),
        resolved_(options.resolved),
        scene_(new Scene()) {
    if (resolved_) *resolved_ = spec;
  }

  std::unique_ptr<Scene> Compile() {
    scene_->camera_ = CreateCamera(spec_.camera, &diagnostics_,
                                   EmptiedParams(resolved_ ? &resolved_->camera : nullptr));
    scene_->is_moving_ = scene_->camera_ && scene_->camera_->IsMoving();
    CompileBackground();
    node_interiors_ = CompileInteriors(spec_, &diagnostics_, resolved_);
    materials_.emplace(spec_, node_interiors_.media, &diagnostics_, resolved_);
    CompileNodes();
    if (sun_) AddLight(std::move(sun_), "directional", spec_.file, spec_.background.light_group);
    if (diagnostics_.HasErrors()) return nullptr;
    TakeMaterials();
    BakeMeshes();
    PlaceLights();
    BuildTree();
    if (diagnostics_.HasErrors()) return nullptr;
    return std::move(scene_);
  }

 private:
  /// Of an object of the scene: what is of no use once that is compiled.
  struct Place {
    Mat4 world_from_object;
    SourceLocation where;   ///< For messages about its place,
    SourceLocation object;  ///< and about itself.
  };

  void CompileBackground() {
    const BackgroundSpec& background = spec_.background;
    scene_->background_.color = background.color;
    scene_->background_.ambient_light = background.ambient_light;
    scene_->group_of_background_ = IndexOfGroup(background.light_group);
    if (!background.cube_map.empty()) {
      scene_->background_.cube_map = CubeMap::Load(spec_.folder / background.cube_map,
                                                   background.cube_map_where, &diagnostics_);
    }
    if (!background.environment.empty()) {
      scene_->background_.environment = EnvironmentMap::Load(
          spec_.folder / background.environment, background.environment_where,
          background.environment_scale, background.environment_rotate_degrees, &diagnostics_);
    }
    if (background.sky) CompileSky(*background.sky, background.environment_scale);
    if (background.fog) {
      scene_->fog_.emplace(*background.fog);
      scene_->fog_place_ = background.fog->where;
    }
  }

  /// The sky is a picture of the surroundings, its sun a light like others.
  void CompileSky(const SkySpec& sky, float scale) {
    const double elevation = double{sky.sun_elevation_degrees};
    const double azimuth = double{sky.sun_azimuth_degrees};
    const double level = CosDegrees(elevation);
    const Vec3 to_sun = Normalize(ToFloat(
        Vec3d{SinDegrees(azimuth) * level, SinDegrees(elevation), -CosDegrees(azimuth) * level}));
    const Daylight daylight(sky.turbidity, to_sun);
    const Rgb sun = sky.has_sun ? daylight.SunIrradiance() : Rgb();
    scene_->background_.environment =
        MakeDaylightMap(daylight, to_sun, sun, sky.ground_albedo, scale);
    if (!sky.has_sun) return;
    sun_ = std::make_unique<DirectionalLight>(-to_sun, sun * scale, Daylight::kSunAngleDegrees);
  }

  void CompileNodes() {
    const std::vector<NodePlace> world_from_node = PlacesOfNodes(spec_, &diagnostics_);
    for (size_t i = 0; i < spec_.nodes.size(); ++i) {
      CompileNode(spec_.nodes[i], world_from_node[i], resolved_ ? &resolved_->nodes[i] : nullptr);
    }
  }

  void CompileNode(const NodeSpec& node, const NodePlace& world_from_node, NodeSpec* resolved) {
    uint32_t light = SceneObject::kNoLight;
    if (node.light) light = CompileLight(node, world_from_node, resolved);
    if (node.object) CompileObject(node, world_from_node, light, resolved);
    if (!node.object && node.material && materials_->MaterialOf(node)) {
      diagnostics_.Warning(node.material->where,
                           "there is no object in this node that could be made of the material");
    }
  }

  /// The index of the node's light when it is the surface of the node's object, else kNoLight.
  uint32_t CompileLight(const NodeSpec& node, const NodePlace& world_from_node,
                        NodeSpec* resolved) {
    LightGroup group;
    const LightContext context{Transform(world_from_node.begin),
                               node.object.has_value(),
                               EmptiedParams(resolved ? &*resolved->light : nullptr),
                               &materials_->textures(),
                               &ies_files_,
                               &group};
    auto light = CreateLight(*node.light, context, &diagnostics_);
    if (!light) return SceneObject::kNoLight;
    if (!IsFinite(context.world_from_node.Point({0, 0, 0}))) {
      diagnostics_.Warning(node.light->where,
                           "the light is left out: its place is too far away for single precision");
      return SceneObject::kNoLight;
    }
    const auto index = static_cast<uint32_t>(scene_->lights_.size());
    const bool is_surface = light->IsSurface();
    if (!is_surface && world_from_node.IsMoving()) {
      diagnostics_.Error(node.light->where, [&] {
        return fmt::format(
            "a light of the type {} cannot move, as the 'Keyframes' of its node, or of "
            "one around it, would have it; of all lights 'area' can",
            Quote(node.light->type));
      });
    }
    if (is_surface) surface_lights_[index] = light.get();
    AddLight(std::move(light), node.light->type, node.light->where, group);
    return is_surface ? index : SceneObject::kNoLight;
  }

  void AddLight(std::unique_ptr<Light> light, std::string type, const SourceLocation& where,
                const LightGroup& group) {
    scene_->lights_.push_back(std::move(light));
    scene_->light_types_.push_back(std::move(type));
    scene_->light_places_.push_back(where);
    scene_->group_of_light_.push_back(IndexOfGroup(group));
  }

  /// The place of a group in those of the scene, of which it may be the first to be met.
  uint32_t IndexOfGroup(const LightGroup& group) {
    std::vector<std::string>& groups = scene_->light_groups_;
    const auto found = std::ranges::find(groups, group.name);
    const auto index = static_cast<uint32_t>(found - groups.begin());
    if (found != groups.end()) return index;
    if (index == LightGroup::kMostGroups) {
      if (!has_too_many_groups_) {
        diagnostics_.Error(group.where, [&] {
          return fmt::format(
              "a scene has at most {} groups of lights, '{}' included; {} is one more",
              LightGroup::kMostGroups, LightGroup::kDefault, Quote(group.name));
        });
      }
      has_too_many_groups_ = true;
      return 0;
    }
    groups.push_back(group.name);
    return index;
  }

  void CompileObject(const NodeSpec& node, const NodePlace& place, uint32_t light,
                     NodeSpec* resolved) {
    const Mat4& world_from_node = place.begin;
    const TypedSpec& spec = *node.object;
    ShapeContext context{&diagnostics_, spec.where,
                         [this](const ParamWord& path) {
                           const auto found = spec_.meshes.find(spec_.PathInScene(path));
                           return found == spec_.meshes.end() ? nullptr : found->second;
                         },
                         &made_of_meshes_, EmptiedParams(resolved ? &*resolved->object : nullptr)};
    auto shape = CreateShape(spec, &context);
    const auto material = materials_->MaterialOf(node);
    if (resolved && !node.material && material) resolved->material = {{}, *material, spec.where};
    if (!shape || !material) return;

    const SourceLocation& where =
        node.transform_where.line != 0 ? node.transform_where : spec.where;
    const auto object_from_world = InverseAffine(world_from_node);
    if (!object_from_world) {
      diagnostics_.Warning(
          where,
          "the object is left out: its transform is singular (it has no inverse in "
          "single precision)");
      return;
    }
    scene_->objects_.push_back({std::move(shape), Transform(world_from_node),
                                Transform(*object_from_world), *material, light, false, spec.type,
                                DescriptionOf(spec)});
    const Material* made_of = materials_->At(*material);
    SceneObject& object = scene_->objects_.back();
    object.is_textured = made_of && made_of->NeedsTextureCoordinates();
    object.is_moving = place.IsMoving() || object.shape->IsMoving();
    scene_->is_moving_ |= object.is_moving;
    if (object.is_moving || object.is_textured) {
      object.space = std::make_unique<const MovingTransform>(
          place.IsMoving() ? place.motion : std::vector<Mat4>{world_from_node});
    }
    const Vec3 flat_normal = object.shape->FlatNormal();
    if (!object.is_moving && flat_normal != Vec3()) {
      object.flat_normal = object.NormalToWorld(flat_normal);
    }
    object.has_holes = made_of && made_of->HasHoles();
    scene_->has_holes_ |= object.has_holes;
    object.interior = InteriorOf(node, made_of);
    places_.push_back({world_from_node, where, spec.where});
  }

  /// For people who know which scene it is: only other files are named.
  std::string DescriptionOf(const TypedSpec& object) const {
    const std::string place =
        spec_.IsInSceneFile(object.where)
            ? fmt::format("line {}", object.where.line)
            : fmt::format("{}:{}", DisplayName(*object.where.file), object.where.line);
    return fmt::format("{} of {}", object.type, place);
  }

  /// The index of what fills the node's object.
  uint32_t InteriorOf(const NodeSpec& node, const Material* material) {
    if (!material) return SceneObject::kNoInterior;
    const Medium* body = material->Body();
    if (!body) {
      if (node.interior) {
        diagnostics_.Warning(node.interior->where,
                             "nothing gets into the object: its material lets no light in");
      }
      return SceneObject::kNoInterior;
    }
    const auto index = static_cast<size_t>(&node - spec_.nodes.data());
    const Interior interior = node_interiors_.of_node[index].value_or(Interior{*body});
    const auto next = static_cast<uint32_t>(scene_->interiors_.size());
    const auto [place, is_new] = interior_by_key_.try_emplace(interior.Key(), next);
    if (is_new) scene_->interiors_.push_back(interior);
    return place->second;
  }

  void TakeMaterials() {
    CompiledMaterials compiled = materials_->Take();
    scene_->materials_ = std::move(compiled.materials);
    scene_->material_places_ = std::move(compiled.places);
    scene_->textures_ = std::move(compiled.textures);
    for (const auto& material : scene_->materials_) {
      const Medium* body = material->Body();
      scene_->has_dispersion_ |= body && !body->dispersion.IsNone();
    }
    for (const Interior& interior : scene_->interiors_) {
      scene_->has_dispersion_ |= !interior.medium.dispersion.IsNone();
    }
  }

  /// Moves the triangles of meshes that one object has into the world, where rays need no way to
  /// the object. Those that several objects have stay as they are, however many these may be,
  /// unless they are small: a ray is through with a few triangles before it would have come to
  /// them.
  void BakeMeshes() {
    std::map<const Shape*, size_t> users;
    for (const SceneObject& object : scene_->objects_) ++users[object.shape.get()];

    size_t left = 0;
    for (size_t i = 0; i < scene_->objects_.size(); ++i) {
      SceneObject& object = scene_->objects_[i];
      if (object.shape->Triangles()) {
        const size_t copies = users[object.shape.get()];
        object.is_instance =
            object.is_moving ||
            (copies > 1 && copies * object.shape->PrimitiveCount() > kFewTriangles);
        object.is_baked = !object.is_instance;
        if (object.is_baked && !Bake(places_[i], &object)) continue;
      }
      if (left != i) {
        scene_->objects_[left] = std::move(object);
        places_[left] = std::move(places_[i]);
      }
      ++left;
    }
    scene_->objects_.resize(left);
    places_.resize(left);
    for (const Place& place : places_) scene_->object_places_.push_back(place.object);
  }

  /// False when the object is to be left out.
  bool Bake(const Place& place, SceneObject* object) {
    if (place.world_from_object == Mat4::Identity()) return true;
    object->shape = object->shape->Baked(place.world_from_object);
    if (!object->shape) {
      diagnostics_.Warning(place.where,
                           "the object is left out: its triangles are too far away or too large "
                           "for single precision");
      return false;
    }
    object->world_from_object = object->object_from_world = Transform();
    return true;
  }

  /// Tells the lights that are surfaces where these have come to lie. Points of those that move
  /// cannot be drawn, since that would take the time: their light is found by rays alone.
  void PlaceLights() {
    for (const SceneObject& object : scene_->objects_) {
      if (object.light == SceneObject::kNoLight) continue;
      const Bounds3 box = object.WorldBounds();
      std::unique_ptr<const SurfaceSampler> sampler;
      if (!object.is_moving) {
        sampler = object.shape->MakeSampler(object.world_from_object, object.object_from_world);
      }
      surface_lights_[object.light]->SetSurface(std::move(sampler), box.Center(),
                                                Length(box.Extent()) / 2);
    }
  }

  void BuildTree() {
    std::vector<Mat4> world_from_object;
    for (const Place& place : places_) world_from_object.push_back(place.world_from_object);
    auto tree = BuildSceneTree(scene_->objects_, world_from_object, accelerator_);
    if (tree) {
      scene_->tree_ = *std::move(tree);
    } else {
      diagnostics_.Error(spec_.file, tree.error().message, tree.error().code);
    }
  }

  const SceneSpec& spec_;
  Diagnostics& diagnostics_;
  const AcceleratorKind accelerator_;
  SceneSpec* const resolved_;
  std::unique_ptr<Scene> scene_;
  std::optional<MaterialCompiler> materials_;
  CompiledInteriors node_interiors_;
  std::map<decltype(Interior().Key()), uint32_t> interior_by_key_;
  std::map<std::shared_ptr<const MeshSpec>, std::shared_ptr<const Shape>> made_of_meshes_;
  IesFiles ies_files_;
  bool has_too_many_groups_ = false;  ///< Which was reported.
  std::unique_ptr<Light> sun_;        ///< Of the sky; added behind the lights of the nodes.
  std::map<uint32_t, Light*> surface_lights_;  ///< By their index, while they can be changed.
  std::vector<Place> places_;                  ///< Of `scene_->objects_`.
};

std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics,
                                    const CompileOptions& options) {
  return SceneCompiler(spec, diagnostics, options).Compile();
}

}  // namespace candela
