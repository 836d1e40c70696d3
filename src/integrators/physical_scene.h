#pragma once

#include <string_view>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace candela {

/// Reports fog, and each material that does what light cannot do, or what light transport does not
/// know of it, if an object is made of it; the messages name the integrator that asks.
void CheckPhysical(const Scene& scene, std::string_view integrator, Diagnostics* diagnostics);

}  // namespace candela
