#include "scene/compile_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "base/text.h"
#include "materials/energy_store.h"
#include "materials/registry.h"
#include "scene/resolved_params.h"
#include "textures/registry.h"

namespace candela {
namespace {

/// Among more names than a person would read the search for a similar one would take its time.
constexpr size_t kMostSuggested = 1000;

}  // namespace

MaterialCompiler::MaterialCompiler(const SceneSpec& spec, std::vector<Medium> media,
                                   Diagnostics* diagnostics, SceneSpec* resolved)
    : spec_(spec),
      diagnostics_(*diagnostics),
      resolved_(resolved),
      context_{{diagnostics,
                [this](const ParamWord& path) { return spec_.folder / spec_.PathInScene(path); },
                [this](std::string_view name, const SourceLocation& where) {
                  return TextureNamed(name, where);
                }},
               [this](std::string_view name, const SourceLocation& where) {
                 return PartNamed(name, where);
               },
               std::move(media),
               std::make_shared<EnergyStore>()} {
  CompileTextures();
  CompileMaterials();
}

void MaterialCompiler::CompileTextures() {
  for (size_t i = 0; i < spec_.textures.size(); ++i) {
    const TextureSpec& spec = spec_.textures[i];
    context_.resolved = EmptiedParams(resolved_ ? &resolved_->textures[i].texture : nullptr);
    auto texture = CreateTexture(spec.texture, context_);
    if (!spec.name.empty()) texture_by_name_.try_emplace(spec.name, texture);
    if (texture) compiled_.textures.push_back(std::move(texture));
  }
}

/// Null when there is no such texture, or when it could not be made; either is reported once.
std::shared_ptr<const Texture> MaterialCompiler::TextureNamed(std::string_view name,
                                                              const SourceLocation& where) {
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
    if (is_below) return fmt::format("a texture uses only those above it, unlike {}", Quote(name));
    return fmt::format("there is no texture named {}{}", Quote(name), DidYouMean(name, names));
  });
  return nullptr;
}

void MaterialCompiler::CompileMaterials() {
  for (size_t i = 0; i < spec_.materials.size(); ++i) {
    const MaterialSpec& material = spec_.materials[i];
    AddMaterial(material.material, resolved_ ? &resolved_->materials[i].material : nullptr);
    if (!material.name.empty()) {
      material_by_name_.try_emplace(material.name, static_cast<uint32_t>(i));
    }
  }
}

void MaterialCompiler::AddMaterial(const TypedSpec& spec, TypedSpec* resolved) {
  context_.resolved = EmptiedParams(resolved);
  compiled_.materials.push_back(CreateMaterial(spec, context_));
  compiled_.places.push_back(spec.where);
}

/// The index of the node's material; nothing when there is no such material, which is reported.
std::optional<uint32_t> MaterialCompiler::MaterialOf(const NodeSpec& node) {
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

std::optional<uint32_t> MaterialCompiler::MaterialNamed(const MaterialReference& reference) {
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
const Material* MaterialCompiler::PartNamed(std::string_view name, const SourceLocation& where) {
  const bool is_below = !material_by_name_.contains(name) &&
                        std::any_of(spec_.materials.begin(), spec_.materials.end(),
                                    [&](const MaterialSpec& each) { return each.name == name; });
  if (is_below) {
    diagnostics_.Error(where,
                       fmt::format("a material is made of those above it, unlike {}", Quote(name)));
    return nullptr;
  }
  MaterialReference reference;
  reference.name = name;
  reference.where = where;
  const auto index = MaterialNamed(reference);
  return index ? compiled_.materials[*index].get() : nullptr;
}

template <class MakeText>
void MaterialCompiler::ReportNoMaterial(const SourceLocation& where, const MakeText& make_text) {
  if (!spec_.materials_are_damaged) diagnostics_.Error(where, make_text);
}

uint32_t MaterialCompiler::DefaultMaterial(const SourceLocation& where) {
  diagnostics_.Warning(where, "the object has no material; the default one is used");
  if (!default_material_) {
    const TypedSpec plain{
        "phong", where, {{{"diffuse", where, {{"0.8", where}, {"0.8", where}, {"0.8", where}}}}}};
    default_material_ = static_cast<uint32_t>(compiled_.materials.size());
    if (resolved_) resolved_->materials.push_back({plain, {}, {}});
    AddMaterial(plain, resolved_ ? &resolved_->materials.back().material : nullptr);
  }
  return *default_material_;
}

}  // namespace candela
