#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "materials/medium.h"
#include "textures/texture_context.h"

namespace candela {

class EnergyStore;
class Material;

/// What a material may ask for while it is created.
struct MaterialContext : TextureContext {
  /// The material of a name, of those that stand above in the scene and outlive the one that asks;
  /// null when there is none, or when it could not be made, which has been reported.
  std::function<const Material*(std::string_view name, const SourceLocation& where)> find_material;

  /// The media between any two of which a surface may lie, where the scene says what fills objects;
  /// else none. Of those that refract alike only one.
  std::vector<Medium> media;

  /// Where materials find tables that others have made; null where each makes its own.
  std::shared_ptr<EnergyStore> energies = nullptr;
};

}  // namespace candela
