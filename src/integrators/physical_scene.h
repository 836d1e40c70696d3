#pragma once

#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace candela {

/// Fails when a material of the scene does what light cannot do; the message names the integrator
/// that asks.
Result<void> CheckPhysical(const Scene& scene, std::string_view integrator);

}  // namespace candela
