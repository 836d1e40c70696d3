#pragma once

#include "math/vec.h"
#include "scene/scene.h"

namespace candela {

/// What a camera ray finds first, for normal and depth maps.
struct FirstHit {
  bool is_hit = false;
  Vec3 normal;      ///< Unit shading normal in world space; 0 for a miss.
  float depth = 0;  ///< Distance along the ray; 0 for a miss.
};

/// Traces the camera ray through a point of the image plane.
FirstHit FindFirstHit(const Scene& scene, Vec2 image_point);

}  // namespace candela
