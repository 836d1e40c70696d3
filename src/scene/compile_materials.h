#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/scene_spec.h"
#include "textures/texture.h"

namespace candela {

/// What the objects of a scene can be made of. What several of them have in common is there once.
struct CompiledMaterials {
  /// At their indices in the description, and behind them one for objects that have none. Null
  /// where one could not be made, which has been reported.
  std::vector<std::unique_ptr<const Material>> materials;
  std::vector<SourceLocation> places;  ///< Where each of them is described.
  std::vector<std::shared_ptr<const Texture>> textures;
};

/// Makes the textures and the materials of a scene, each of which may use those above it, and finds
/// them by name and by index.
class MaterialCompiler {
 public:
  /// `media` are those of `CompiledInteriors`. `resolved`, where it is not null, is a copy of the
  /// description that gets all parameters. All of them have to outlive the compiler.
  MaterialCompiler(const SceneSpec& spec, std::vector<Medium> media, Diagnostics* diagnostics,
                   SceneSpec* resolved);

  MaterialCompiler(const MaterialCompiler&) = delete;
  MaterialCompiler& operator=(const MaterialCompiler&) = delete;

  /// The index of the node's material; nothing when there is no such material, which is reported. A
  /// node without one has to have an object.
  std::optional<uint32_t> MaterialOf(const NodeSpec& node);

  /// What finds the textures, for others who use them; as long as the compiler lives.
  const TextureContext& textures() const { return context_; }

  /// Null when it could not be made.
  const Material* At(uint32_t index) const { return compiled_.materials[index].get(); }

  /// Everything, in the end.
  CompiledMaterials Take() { return std::move(compiled_); }

 private:
  void CompileTextures();
  void CompileMaterials();
  void AddMaterial(const TypedSpec& spec, TypedSpec* resolved);
  std::shared_ptr<const Texture> TextureNamed(std::string_view name, const SourceLocation& where);
  std::optional<uint32_t> MaterialNamed(const MaterialReference& reference);
  const Material* PartNamed(std::string_view name, const SourceLocation& where);
  uint32_t DefaultMaterial(const SourceLocation& where);
  template <class MakeText>
  void ReportNoMaterial(const SourceLocation& where, const MakeText& make_text);

  const SceneSpec& spec_;
  Diagnostics& diagnostics_;
  SceneSpec* resolved_;
  MaterialContext context_;
  std::map<std::string_view, std::shared_ptr<const Texture>> texture_by_name_;
  std::map<std::string_view, uint32_t> material_by_name_;
  std::optional<uint32_t> default_material_;
  CompiledMaterials compiled_;
};

}  // namespace candela
