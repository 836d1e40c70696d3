#pragma once

#include "math/vec.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Where in a texture the point with some texture coordinates lies: these are scaled, then turned,
/// then moved.
class UvTransform {
 public:
  UvTransform() = default;
  static UvTransform Create(ParamReader* params);

  Vec2 Apply(Vec2 uv) const { return Vector(uv) + offset_; }
  /// The same for a difference.
  Vec2 Vector(Vec2 d) const { return {u_.x * d.x + u_.y * d.y, v_.x * d.x + v_.y * d.y}; }

 private:
  Vec2 u_{1, 0}, v_{0, 1};  // Rows.
  Vec2 offset_;
};

}  // namespace candela
