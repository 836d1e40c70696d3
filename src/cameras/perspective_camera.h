#pragma once

#include "geometry/ray.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// A pinhole camera after the course: `up` is used as it was given, not made orthogonal to the
/// direction of view. Immutable; called concurrently.
class PerspectiveCamera {
 public:
  explicit PerspectiveCamera(const CameraSpec& spec);

  /// The ray through a point of the image plane, where y goes upwards and -1 and 1 are the lower
  /// and the upper edge of the field of view; x has the same unit. The direction is a unit vector.
  Ray GenerateRay(Vec2 image_point) const {
    Ray ray(center_, Normalize(forward_ + right_ * image_point.x + up_ * image_point.y));
    ray.mask = kCameraRay;
    return ray;
  }

 private:
  Vec3 center_;
  Vec3 forward_;     ///< From the centre to the middle of the image plane.
  Vec3 right_, up_;  ///< From there to the edges of the field of view.
};

}  // namespace candela
