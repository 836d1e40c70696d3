#pragma once

#include <string>

#include "base/diagnostics.h"
#include "scene/compile_scene.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Checks the blocks `Render` and `Film` of a scene as `candela render` does, and gives the options
/// that `candela render SCENE` would then use, as such blocks: with what follows from others and
/// from defaults, without options that have no value then.
struct RenderSettings {
  ParamSet render, film;
  std::string integrator;  ///< One of the registry.
  CompileOptions compilation;
};
RenderSettings ReadRenderSettings(const SceneSpec& spec, Diagnostics* diagnostics);

}  // namespace candela
