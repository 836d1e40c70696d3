#pragma once

#include <functional>
#include <string_view>

#include "textures/texture_context.h"

namespace candela {

class Material;

/// What a material may ask for while it is created.
struct MaterialContext : TextureContext {
  /// The material of a name, of those that stand above in the scene and outlive the one that asks;
  /// null when there is none, or when it could not be made, which has been reported.
  std::function<const Material*(std::string_view name, const SourceLocation& where)> find_material;
};

}  // namespace candela
