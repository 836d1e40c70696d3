#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "base/diagnostics.h"
#include "scene_spec/param_set.h"

namespace candela {

class Texture;

/// What textures, and what uses them, may ask for while they are created.
struct TextureContext {
  Diagnostics* diagnostics;
  /// The file that a path in the scene means.
  std::function<std::filesystem::path(const ParamWord& path)> find_file;

  /// The texture of a name, of those that stand above in the scene; null when there is none, which
  /// has been reported at `where`.
  std::function<std::shared_ptr<const Texture>(std::string_view name, const SourceLocation& where)>
      find_texture;

  /// Gets the parameters of what is created, those included that are not given; may be null.
  ParamSet* resolved = nullptr;
};

}  // namespace candela
