#pragma once

#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace candela {

/// Fails when bodies of the same priority may overlap: what fills the place is then said by the
/// body that light has got into last, and so depends on the direction that it is followed in. The
/// message names the integrator that asks, which follows light in the other one. Bodies of which
/// the boxes overlap are taken for such.
Result<void> CheckMediaAreSymmetric(const Scene& scene, std::string_view integrator);

}  // namespace candela
