#include "scene/compile_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "lights/registry.h"
#include "materials/registry.h"
#include "scene/compile_interiors.h"
#include "shapes/registry.h"
#include "textures/registry.h"

namespace candela {

/// Holds what is known while a scene is compiled.
class SceneCompiler {
 public:
  /// So many triangles are copied for each object rather than shared, all copies together.
  static constexpr uint64_t kFewTriangles = 1000;
  /// Among more names than a person would read the search for a similar one would take its time.
  static constexpr size_t kMostSuggested = 1000;

  SceneCompiler(const SceneSpec& spec, Diagnostics* diagnostics, SceneSpec* resolved)
      : spec_(spec),
        diagnostics_(*diagnostics),
        resolved_(resolved),
        scene_(new Scene(spec.camera)),
        material_context_{
            {diagnostics,
             [this](const ParamWord& path) { return spec_.folder / spec_.PathInScene(path); },
             [this](std::string_view name, const SourceLocation& where) {
               return TextureNamed(name, where);
             }},
            [this](std::string_view name, const SourceLocation& where) {
              return PartNamed(name, where);
            },
            {}} {
    if (resolved_) *resolved_ = spec;
  }

  std::unique_ptr<Scene> Compile() {
    CompileBackground();
    CompileTextures();
    node_interiors_ = CompileInteriors(spec_, &diagnostics_, resolved_);
    material_context_.indices = node_interiors_.indices;
    CompileMaterials();
    CompileNodes();
    if (diagnostics_.HasErrors()) return nullptr;
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

  /// The parameters of an object in the resolved description, to be filled; null without one.
  static ParamSet* EmptyParams(TypedSpec* resolved) {
    if (!resolved) return nullptr;
    resolved->params.params.clear();
    return &resolved->params;
  }

  void CompileBackground() {
    const BackgroundSpec& background = spec_.background;
    scene_->background_.color = background.color;
    scene_->background_.ambient_light = background.ambient_light;
    if (!background.cube_map.empty()) {
      scene_->background_.cube_map = CubeMap::Load(spec_.folder / background.cube_map,
                                                   background.cube_map_where, &diagnostics_);
    }
    if (!background.environment.empty()) {
      scene_->background_.environment = EnvironmentMap::Load(
          spec_.folder / background.environment, background.environment_where,
          background.environment_scale, background.environment_rotate_degrees, &diagnostics_);
    }
  }

  void CompileTextures() {
    for (size_t i = 0; i < spec_.textures.size(); ++i) {
      const TextureSpec& spec = spec_.textures[i];
      material_context_.resolved =
          EmptyParams(resolved_ ? &resolved_->textures[i].texture : nullptr);
      auto texture = CreateTexture(spec.texture, material_context_);
      if (!spec.name.empty()) texture_by_name_.try_emplace(spec.name, texture);
      if (texture) scene_->textures_.push_back(std::move(texture));
    }
  }

  /// Null when there is no such texture, or when it could not be made; either is reported once.
  std::shared_ptr<const Texture> TextureNamed(std::string_view name, const SourceLocation& where) {
    const auto found = texture_by_name_.find(name);
    if (found != texture_by_name_.end()) return found->second;
    if (spec_.textures_are_damaged) return nullptr;
    diagnostics_.Error(where, [&] {
      std::vector<std::string_view> names;
      bool is_below = false;
      for (const TextureSpec& texture : spec_.textures) {
        is_below = is_below || texture.name == name;
        if (names.size() < kMostSuggested) names.push_back(texture.name);
      }
      if (is_below)
        return fmt::format("a texture uses only those above it, unlike {}", Quote(name));
      return fmt::format("there is no texture named {}{}", Quote(name), DidYouMean(name, names));
    });
    return nullptr;
  }

  void CompileMaterials() {
    for (size_t i = 0; i < spec_.materials.size(); ++i) {
      const MaterialSpec& material = spec_.materials[i];
      AddMaterial(material.material, resolved_ ? &resolved_->materials[i].material : nullptr);
      if (!material.name.empty()) {
        material_by_name_.try_emplace(material.name, static_cast<uint32_t>(i));
      }
    }
  }

  void AddMaterial(const TypedSpec& spec, TypedSpec* resolved) {
    material_context_.resolved = EmptyParams(resolved);
    scene_->materials_.push_back(CreateMaterial(spec, material_context_));
    scene_->material_places_.push_back(spec.where);
  }

  void CompileNodes() {
    std::vector<Mat4> world_from_node;
    world_from_node.reserve(spec_.nodes.size());
    for (size_t i = 0; i < spec_.nodes.size(); ++i) {
      const NodeSpec& node = spec_.nodes[i];
      const bool is_root = node.parent == NodeSpec::kNoParent;
      world_from_node.push_back(is_root ? node.parent_from_node
                                        : world_from_node[node.parent] * node.parent_from_node);
      CompileNode(node, world_from_node.back(), resolved_ ? &resolved_->nodes[i] : nullptr);
    }
  }

  void CompileNode(const NodeSpec& node, const Mat4& world_from_node, NodeSpec* resolved) {
    uint32_t light = SceneObject::kNoLight;
    if (node.light) light = CompileLight(node, world_from_node, resolved);
    if (node.object) CompileObject(node, world_from_node, light, resolved);
    if (!node.object && node.material && MaterialOf(node)) {
      diagnostics_.Warning(node.material->where,
                           "there is no object in this node that could be made of the material");
    }
  }

  /// The index of the node's light when it is the surface of the node's object, else kNoLight.
  uint32_t CompileLight(const NodeSpec& node, const Mat4& world_from_node, NodeSpec* resolved) {
    const LightContext context{Transform(world_from_node), node.object.has_value(),
                               EmptyParams(resolved ? &*resolved->light : nullptr)};
    auto light = CreateLight(*node.light, context, &diagnostics_);
    if (!light) return SceneObject::kNoLight;
    if (!IsFinite(context.world_from_node.Point({0, 0, 0}))) {
      diagnostics_.Warning(node.light->where,
                           "the light is left out: its place is too far away for single precision");
      return SceneObject::kNoLight;
    }
    const auto index = static_cast<uint32_t>(scene_->lights_.size());
    const bool is_surface = light->IsSurface();
    if (is_surface) surface_lights_[index] = light.get();
    scene_->lights_.push_back(std::move(light));
    scene_->light_types_.push_back(node.light->type);
    return is_surface ? index : SceneObject::kNoLight;
  }

  void CompileObject(const NodeSpec& node, const Mat4& world_from_node, uint32_t light,
                     NodeSpec* resolved) {
    const TypedSpec& spec = *node.object;
    ShapeContext context{&diagnostics_, spec.where,
                         [this](const ParamWord& path) {
                           const auto found = spec_.meshes.find(spec_.PathInScene(path));
                           return found == spec_.meshes.end() ? nullptr : found->second;
                         },
                         &made_of_meshes_, EmptyParams(resolved ? &*resolved->object : nullptr)};
    auto shape = CreateShape(spec, &context);
    const auto material = MaterialOf(node);
    if (!shape || !material) return;
    if (resolved && !node.material) resolved->material = {{}, *material, spec.where};

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
    const auto& made_of = scene_->materials_[*material];
    SceneObject& object = scene_->objects_.back();
    object.is_textured = made_of && made_of->NeedsTextureCoordinates();
    object.has_holes = made_of && made_of->HasHoles();
    scene_->has_holes_ |= object.has_holes;
    object.interior = InteriorOf(node, made_of.get());
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

  /// The index of the node's material; nothing when there is no such material, which is reported.
  std::optional<uint32_t> MaterialOf(const NodeSpec& node) {
    if (!node.material) return DefaultMaterial(node.object->where);
    const MaterialReference& reference = *node.material;
    if (!reference.name.empty()) return MaterialNamed(reference);
    if (!reference.index) return std::nullopt;

    const auto count = static_cast<int64_t>(spec_.materials.size());
    if (*reference.index >= 0 && *reference.index < count) {
      return static_cast<uint32_t>(*reference.index);
    }
    ReportNoMaterial(reference.where, [&] {
      const std::string list = count == 0   ? "the scene has none"
                               : count == 1 ? "the scene has only material 0"
                                            : fmt::format("the scene has 0 to {}", count - 1);
      return fmt::format("there is no material {}: {}", *reference.index, list);
    });
    return std::nullopt;
  }

  std::optional<uint32_t> MaterialNamed(const MaterialReference& reference) {
    const auto found = material_by_name_.find(reference.name);
    if (found != material_by_name_.end()) return found->second;
    ReportNoMaterial(reference.where, [&] {
      std::vector<std::string_view> names;
      for (const auto& [name, index] : material_by_name_) {
        if (names.size() < kMostSuggested) names.push_back(name);
      }
      return fmt::format("there is no material named {}{}", Quote(reference.name),
                         DidYouMean(reference.name, names));
    });
    return std::nullopt;
  }

  /// A material for another one that is made of it; null when it is missing or wrong, which is
  /// reported.
  const Material* PartNamed(std::string_view name, const SourceLocation& where) {
    const bool is_below = !material_by_name_.contains(name) &&
                          std::any_of(spec_.materials.begin(), spec_.materials.end(),
                                      [&](const MaterialSpec& each) { return each.name == name; });
    if (is_below) {
      diagnostics_.Error(
          where, fmt::format("a material is made of those above it, unlike {}", Quote(name)));
      return nullptr;
    }
    MaterialReference reference;
    reference.name = name;
    reference.where = where;
    const auto index = MaterialNamed(reference);
    return index ? scene_->materials_[*index].get() : nullptr;
  }

  template <class MakeText>
  void ReportNoMaterial(const SourceLocation& where, const MakeText& make_text) {
    if (!spec_.materials_are_damaged) diagnostics_.Error(where, make_text);
  }

  uint32_t DefaultMaterial(const SourceLocation& where) {
    diagnostics_.Warning(where, "the object has no material; the default one is used");
    if (!default_material_) {
      const TypedSpec plain{
          "phong", where, {{{"diffuse", where, {{"0.8", where}, {"0.8", where}, {"0.8", where}}}}}};
      default_material_ = static_cast<uint32_t>(scene_->materials_.size());
      if (resolved_) resolved_->materials.push_back({plain, {}, {}});
      AddMaterial(plain, resolved_ ? &resolved_->materials.back().material : nullptr);
    }
    return *default_material_;
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
        object.is_instance = copies > 1 && copies * object.shape->PrimitiveCount() > kFewTriangles;
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

  /// Tells the lights that are surfaces where these have come to lie.
  void PlaceLights() {
    for (const SceneObject& object : scene_->objects_) {
      if (object.light == SceneObject::kNoLight) continue;
      const Bounds3 box = TransformBounds(object.world_from_object, object.shape->ObjectBounds());
      surface_lights_[object.light]->SetSurface(
          object.shape->MakeSampler(object.world_from_object, object.object_from_world),
          box.Center(), Length(box.Extent()) / 2);
    }
  }

  void BuildTree() {
    std::vector<Mat4> world_from_object;
    for (const Place& place : places_) world_from_object.push_back(place.world_from_object);
    auto tree = BuildSceneTree(scene_->objects_, world_from_object);
    if (tree) {
      scene_->tree_ = *std::move(tree);
    } else {
      diagnostics_.Error(spec_.file, tree.error().message, tree.error().code);
    }
  }

  const SceneSpec& spec_;
  Diagnostics& diagnostics_;
  SceneSpec* resolved_;
  std::unique_ptr<Scene> scene_;
  MaterialContext material_context_;
  std::map<std::string_view, std::shared_ptr<const Texture>> texture_by_name_;
  std::map<std::string_view, uint32_t> material_by_name_;
  std::optional<uint32_t> default_material_;
  CompiledInteriors node_interiors_;
  std::map<decltype(Interior().Key()), uint32_t> interior_by_key_;
  std::map<std::shared_ptr<const MeshSpec>, std::shared_ptr<const Shape>> made_of_meshes_;
  std::map<uint32_t, Light*> surface_lights_;  ///< By their index, while they can be changed.
  std::vector<Place> places_;                  ///< Of `scene_->objects_`.
};

std::vector<std::filesystem::path> ContentFiles(const SceneSpec& spec) {
  std::vector<std::filesystem::path> files = spec.files;
  if (!spec.background.cube_map.empty()) {
    const auto faces = CubeMap::FaceFiles(spec.folder / spec.background.cube_map);
    files.insert(files.end(), faces.begin(), faces.end());
  }
  if (!spec.background.environment.empty()) {
    files.push_back(spec.folder / spec.background.environment);
  }
  for (const TextureSpec& texture : spec.textures) {
    const Param* file = texture.texture.params.Find("file");
    if (texture.texture.type == "image" && file && file->words.size() == 1) {
      files.push_back(spec.folder / spec.PathInScene(file->words[0]));
    }
  }
  return files;
}

std::vector<std::filesystem::path> InputFiles(const SceneSpec& spec) {
  std::vector<std::filesystem::path> files = ContentFiles(spec);
  files.insert(files.end(), spec.mtl_files.begin(), spec.mtl_files.end());
  return files;
}

std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics,
                                    SceneSpec* resolved) {
  return SceneCompiler(spec, diagnostics, resolved).Compile();
}

}  // namespace candela
