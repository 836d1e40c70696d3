#pragma once

#include <vector>

#include "integrators/first_hit.h"
#include "render/render_options.h"
#include "scene/scene.h"

namespace candela {

/// What the camera ray through the middle of each pixel of the crop window finds first, row by row.
std::vector<FirstHit> RenderFirstHits(const Scene& scene, const RenderOptions& options);

}  // namespace candela
