#pragma once

#include "base/diagnostics.h"
#include "math/mat4.h"
#include "scene_spec/param_set.h"

namespace candela {

/// The product of the steps of a `Transform` block, in the order they were written: the last one
/// acts first on the object. Steps that are wrong are reported and left out.
Mat4 ComposeSteps(const ParamSet& steps, Diagnostics* diagnostics);

}  // namespace candela
