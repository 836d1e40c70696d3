#pragma once

#include <string_view>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace candela {

/// Reports bodies that may overlap with one of the same priority: what fills the place is then said
/// by the body that light has got into last, and so depends on the direction that it is followed
/// in. The messages name the integrator that asks, which follows light in the other one. Bodies of
/// which the boxes overlap are taken for such; each is reported once, with one that comes before it
/// in the scene.
void CheckMediaAreSymmetric(const Scene& scene, std::string_view integrator,
                            Diagnostics* diagnostics);

}  // namespace candela
