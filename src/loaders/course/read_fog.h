#pragma once

#include <optional>

#include "scene_spec/param_reader.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Reads the parameters of a background that describe a fog; nothing when there is no `fog`, and
/// then none of them may be there either.
std::optional<FogSpec> ReadFog(ParamReader* reader);

}  // namespace candela
