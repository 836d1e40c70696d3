#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "base/diagnostics.h"

namespace candela {

class Texture;

/// What textures, and what uses them, may ask for while they are created.
struct TextureContext {
  Diagnostics* diagnostics;
  std::filesystem::path folder;  ///< Paths in the scene are relative to it.

  /// The texture of a name, of those that stand above in the scene; null when there is none, which
  /// has been reported at `where`.
  std::function<std::shared_ptr<const Texture>(std::string_view name, const SourceLocation& where)>
      find_texture;
};

}  // namespace candela
