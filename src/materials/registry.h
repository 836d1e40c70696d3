#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A kind of material that scenes may name.
struct MaterialEntry {
  std::string_view name;
  std::unique_ptr<Material> (*create)(ParamReader* params, const MaterialContext& context);
  /// The body of a `Material` block that the contract tests and the manual use.
  std::string_view example;
};

std::span<const MaterialEntry> MaterialEntries();

/// Creates the material that `spec` describes; null when there is no such kind.
std::unique_ptr<Material> CreateMaterial(const TypedSpec& spec, const MaterialContext& context);

}  // namespace candela
