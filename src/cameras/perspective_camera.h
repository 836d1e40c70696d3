#pragma once

#include <optional>

#include "geometry/ray.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// What a point needs to know to send light to the camera.
struct CameraConnection {
  Vec3 direction;    ///< Unit vector from the point to the lens,
  float distance;    ///< and how far it is.
  Vec2 image_point;  ///< Where light from there is seen.
  float importance;  ///< The area of the image plane per area across `direction` at the point: what
                     ///< turns power that is sent to the camera, per solid angle, into radiance
                     ///< over the image plane, as a density over its area.
};

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

  /// The way from the point `p` to the camera, through a point of the lens that is drawn with two
  /// numbers in [0, 1) as `GenerateRay` does. Nothing when no image point shows `p` through it. The
  /// inverse of `GenerateRay`: the ray through that image point with the same numbers meets `p`.
  std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const;

  /// Whether all rays go through one point.
  bool IsPinhole() const { return lens_radius_ == 0; }

 private:
  Vec2 SampleLens(Vec2 u) const;
  Vec3 OnLens(Vec2 u) const;
  /// The image point that shows what lies at `way` from the centre; nothing when it is behind.
  std::optional<Vec2> ImagePointOf(Vec3d way) const;

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
