#pragma once

#include "scene_spec/param_set.h"

namespace candela {

/// The parameters of something in the resolved description, to be filled.
inline ParamSet* Emptied(ParamSet* resolved) {
  resolved->params.clear();
  return resolved;
}

/// Those of an object; null without one.
inline ParamSet* EmptiedParams(TypedSpec* resolved) {
  return resolved ? Emptied(&resolved->params) : nullptr;
}

}  // namespace candela
