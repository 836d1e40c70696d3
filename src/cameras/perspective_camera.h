#pragma once

#include "geometry/ray.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// A camera after the course: `up` is used as it was given, not made orthogonal to the direction of
/// view. With an aperture it has a thin lens, which shows sharply what lies in one plane.
/// Immutable; called concurrently.
class PerspectiveCamera {
 public:
  explicit PerspectiveCamera(const CameraSpec& spec);

  /// The ray through the middle of the lens and a point of the image plane, where y goes upwards
  /// and -1 and 1 are the lower and the upper edge of the field of view; x has the same unit. The
  /// direction is a unit vector.
  Ray GenerateRay(Vec2 image_point) const {
    Ray ray(center_, Normalize(forward_ + right_ * image_point.x + up_ * image_point.y));
    ray.mask = kCameraRay;
    return ray;
  }

  /// The same through a point of the lens, drawn with two numbers in [0, 1): it meets the ray
  /// through the middle where that is in focus.
  Ray GenerateRay(Vec2 image_point, Vec2 u) const;

  /// The angle between rays through points of the image plane that are one unit apart, near its
  /// middle, for small distances in proportion.
  float AnglePerUnit() const { return Length(up_) / Length(forward_); }

  /// How far ahead of the camera a point lies, along the direction of view.
  float DepthOf(Vec3 p) const { return Dot(p - center_, view_); }

  /// Whether all rays go through one point.
  bool IsPinhole() const { return lens_radius_ == 0; }

 private:
  Vec2 SampleLens(Vec2 u) const;

  Vec3 center_;
  Vec3 forward_;     ///< From the centre to the middle of the image plane.
  Vec3 right_, up_;  ///< From there to the edges of the field of view.

  float lens_radius_;
  int blades_;
  float focus_distance_;
  Vec3 view_;             ///< The unit direction of view,
  Vec3 lens_x_, lens_y_;  ///< and the axes of the lens, orthogonal to it.
};

}  // namespace candela
