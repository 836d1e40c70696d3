#pragma once

#include <span>

#include "math/vec.h"
#include "scene/scene.h"

namespace candela {

/// What a camera ray finds first, for normal and depth maps.
struct FirstHit {
  bool is_hit = false;
  Vec3 normal;      ///< Unit shading normal in world space; 0 for a miss.
  float depth = 0;  ///< Distance along the ray; 0 for a miss.
};

/// Traces the camera rays, of what moves in the middle of the time that the shutter is open,
/// through points of the image plane; quickest when neighbours in the list are neighbours there.
/// The spans are equally long.
void FindFirstHits(const Scene& scene, std::span<const Vec2> image_points,
                   std::span<FirstHit> first_hits);

}  // namespace candela
