#pragma once

#include "lights/ies_file.h"
#include "math/transform.h"
#include "scene_spec/light_group.h"
#include "scene_spec/param_set.h"
#include "textures/texture_context.h"

namespace candela {

/// What a light may ask for while it is created.
struct LightContext {
  Transform world_from_node;
  bool has_object;  ///< Whether its node has an object, whose surface can shine.
  /// Gets the parameters of the light, those included that are not given; may be null.
  ParamSet* resolved = nullptr;
  /// Finds textures and files for the lights that have some, which are not made without it.
  const TextureContext* textures = nullptr;
  /// The photometric files of the scene that were read, which lamps of one kind share; may be null.
  IesFiles* ies_files = nullptr;
  /// Gets the group that the light is in; may be null.
  LightGroup* group = nullptr;
};

}  // namespace candela
