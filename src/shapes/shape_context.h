#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "base/diagnostics.h"
#include "scene_spec/mesh_spec.h"
#include "scene_spec/param_set.h"

namespace candela {

class Shape;

/// What a shape may ask for while it is created.
struct ShapeContext {
  Diagnostics* diagnostics;
  SourceLocation where;  ///< Of the object that is created.

  /// The mesh of a file that the scene names; null when it could not be loaded, which has been
  /// reported.
  std::function<std::shared_ptr<const MeshSpec>(const ParamWord& path)> find_mesh;

  /// The shapes that were made of meshes: one of each is enough for all objects.
  std::map<std::shared_ptr<const MeshSpec>, std::shared_ptr<const Shape>>* made_of_meshes;

  /// Gets the parameters of the shape, those included that are not given; may be null.
  ParamSet* resolved = nullptr;
};

}  // namespace candela
