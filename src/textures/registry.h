#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "scene_spec/param_reader.h"
#include "textures/texture.h"
#include "textures/texture_context.h"

namespace candela {

/// A kind of texture that scenes may name.
struct TextureEntry {
  std::string_view name;
  std::shared_ptr<const Texture> (*create)(ParamReader* params, const TextureContext& context);
  /// The body of a `Texture` block that the contract tests and the manual use.
  std::string_view example;
};

std::span<const TextureEntry> TextureEntries();

/// Creates the texture that `spec` describes; null when there is no such kind, or when it cannot be
/// made, which is reported.
std::shared_ptr<const Texture> CreateTexture(const TypedSpec& spec, const TextureContext& context);

}  // namespace candela
