#include "scene/compile_scene.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "base/text.h"
#include "lights/registry.h"
#include "materials/registry.h"
#include "shapes/registry.h"

namespace candela {

/// Holds what is known while a scene is compiled.
class SceneCompiler {
 public:
  SceneCompiler(const SceneSpec& spec, Diagnostics* diagnostics)
      : spec_(spec), diagnostics_(*diagnostics), scene_(new Scene(spec.camera)) {}

  std::unique_ptr<Scene> Compile() {
    CompileBackground();
    for (const MaterialSpec& material : spec_.materials) {
      scene_->materials_.push_back(CreateMaterial(material.material, &diagnostics_));
    }
    CompileNodes();
    if (diagnostics_.HasErrors()) return nullptr;
    BuildTree();
    return std::move(scene_);
  }

 private:
  void CompileBackground() {
    const BackgroundSpec& background = spec_.background;
    scene_->background_.color = background.color;
    scene_->background_.ambient_light = background.ambient_light;
    if (background.cube_map.empty()) return;
    scene_->background_.cube_map =
        CubeMap::Load(spec_.folder / background.cube_map, background.cube_map_where, &diagnostics_);
  }

  void CompileNodes() {
    std::vector<Mat4> world_from_node;
    world_from_node.reserve(spec_.nodes.size());
    for (const NodeSpec& node : spec_.nodes) {
      const bool is_root = node.parent == NodeSpec::kNoParent;
      world_from_node.push_back(is_root ? node.parent_from_node
                                        : world_from_node[node.parent] * node.parent_from_node);
      CompileNode(node, world_from_node.back());
    }
  }

  void CompileNode(const NodeSpec& node, const Mat4& world_from_node) {
    uint32_t light = SceneObject::kNoLight;
    if (node.light) {
      const LightContext context{Transform(world_from_node), node.object.has_value()};
      if (auto created = CreateLight(*node.light, context, &diagnostics_)) {
        if (!created->IsDelta()) light = static_cast<uint32_t>(scene_->lights_.size());
        scene_->lights_.push_back(std::move(created));
      }
    }
    if (node.object) CompileObject(node, world_from_node, light);
  }

  void CompileObject(const NodeSpec& node, const Mat4& world_from_node, uint32_t light) {
    const TypedSpec& spec = *node.object;
    ShapeContext context{&diagnostics_, spec.where, [this](const std::string& path) {
                           const auto found = spec_.meshes.find(path);
                           return found == spec_.meshes.end() ? nullptr : found->second;
                         }};
    auto shape = CreateShape(spec, &context);
    const auto material = MaterialOf(node);
    if (!shape || !material) return;

    const auto object_from_world = InverseAffine(world_from_node);
    if (!object_from_world) {
      const bool has_own = node.transform_where.line != 0;
      diagnostics_.Warning(has_own ? node.transform_where : spec.where,
                           "the transform is singular; the object is left out");
      return;
    }
    scene_->objects_.push_back({std::move(shape), Transform(world_from_node),
                                Transform(*object_from_world), *material, light, spec.type,
                                fmt::format("{} of line {}", spec.type, spec.where.line)});
  }

  /// The index of the node's material; nothing, with an error, when there is no such material.
  std::optional<uint32_t> MaterialOf(const NodeSpec& node) {
    if (!node.material) return DefaultMaterial(node.object->where);
    const MaterialReference& reference = *node.material;
    if (reference.name.empty()) {
      const auto count = static_cast<int64_t>(spec_.materials.size());
      if (reference.index >= 0 && reference.index < count) {
        return static_cast<uint32_t>(reference.index);
      }
      diagnostics_.Error(reference.where,
                         count == 0 ? "there are no materials"
                                    : fmt::format("material {} is not in the list of 0 to {}",
                                                  reference.index, count - 1));
      return std::nullopt;
    }
    std::vector<std::string_view> names;
    for (uint32_t i = 0; i < spec_.materials.size(); ++i) {
      if (spec_.materials[i].name == reference.name) return i;
      names.push_back(spec_.materials[i].name);
    }
    diagnostics_.Error(reference.where,
                       fmt::format("there is no material named {}{}", Quote(reference.name),
                                   DidYouMean(reference.name, names)));
    return std::nullopt;
  }

  uint32_t DefaultMaterial(const SourceLocation& where) {
    diagnostics_.Warning(where, "the object has no material; the default one is used");
    if (!default_material_) {
      const TypedSpec plain{
          "phong", where, {{{"diffuse", where, {{"0.8", where}, {"0.8", where}, {"0.8", where}}}}}};
      default_material_ = static_cast<uint32_t>(scene_->materials_.size());
      scene_->materials_.push_back(CreateMaterial(plain, &diagnostics_));
    }
    return *default_material_;
  }

  void BuildTree() {
    std::vector<Bounds3> boxes(scene_->objects_.size());
    for (uint32_t i = 0; i < boxes.size(); ++i) {
      const SceneObject& object = scene_->objects_[i];
      boxes[i] = TransformBounds(object.world_from_object, object.shape->ObjectBounds());
      if (boxes[i].IsFinite() || boxes[i].IsEmpty()) continue;
      scene_->unbounded_.push_back(i);
      boxes[i] = Bounds3();
    }
    scene_->bvh_ = Bvh(boxes);
  }

  const SceneSpec& spec_;
  Diagnostics& diagnostics_;
  std::unique_ptr<Scene> scene_;
  std::optional<uint32_t> default_material_;
};

std::unique_ptr<Scene> CompileScene(const SceneSpec& spec, Diagnostics* diagnostics) {
  return SceneCompiler(spec, diagnostics).Compile();
}

}  // namespace candela
