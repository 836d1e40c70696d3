#pragma once

#include <string_view>

#include "base/diagnostics.h"
#include "scene_spec/param_set.h"

namespace candela {

/// Makes an object's description of the parameters of its block, which stands at `where`. Where
/// there is no parameter `type` the type is `default_type`; without a default that is reported, and
/// the type is empty.
TypedSpec TakeType(ParamSet params, const SourceLocation& where, std::string_view block,
                   std::string_view default_type, Diagnostics* diagnostics);

}  // namespace candela
