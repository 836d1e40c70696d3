#pragma once

#include <optional>

#include "cameras/camera_spec.h"
#include "math/vec.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Where a camera that moves stands and looks at time 1. In between, the three vectors go straight
/// from those of its `CameraSpec` to these.
struct CameraMotion {
  Vec3 center, direction, up;

  /// What the camera is at a time in [0, 1].
  CameraSpec At(const CameraSpec& begin, float time) const;
};

/// Reads `center_end`, `direction_end` and `up_end` of a camera that has been read; nothing when
/// there are none of them. Reports directions that vanish, or meet `up`, on the way.
std::optional<CameraMotion> ReadMotion(ParamReader* params, const CameraSpec& begin);

}  // namespace candela
