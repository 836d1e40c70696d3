#pragma once

#include <cstdint>

#include "math/moving_transform.h"
#include "math/vec.h"

namespace candela {

/// What is known about a hit besides where along the ray it is. In object space when it comes from
/// a shape, in world space when it comes from the scene.
struct SurfacePoint {
  Vec3 p;
  Vec3 p_error;      ///< Bound on the error of `p` in each coordinate; in world space also of its
                     ///< way back to object space.
  Vec3 n_geometric;  ///< Unit normal of the true surface, on the side its definition says.
  Vec3 n_shading;    ///< Unit normal for shading; never flipped towards the viewer.

  /// The normal of the true surface on the side that `n_shading` says is outside.
  Vec3 OutwardNormal() const {
    return Dot(n_geometric, n_shading) < 0 ? -n_geometric : n_geometric;
  }

  // The rest is there only where the material asks for texture coordinates.
  Vec2 uv{};
  Vec3 dpdu{}, dpdv{};  ///< How `p` moves with them; 0 where they say nothing.
  float footprint = 0;  ///< The width of what the ray stands for at the hit; 0 when unknown.
  float time = 0;       ///< Of the ray, for what moves.
  /// The space of the object's node, for textures that fill space; outlives the point. Null where
  /// `p` is in that space.
  const MovingTransform* object_space = nullptr;
};

}  // namespace candela
